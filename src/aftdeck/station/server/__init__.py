"""The web server of the station, its pages and their roles."""
