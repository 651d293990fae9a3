"""Messages between server and page, and the data of a playback: every type once; the TypeScript follows."""
