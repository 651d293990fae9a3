"""The report's steering modes, one file each, and DIRECT."""
