"""Messages between server and page, and the data of a playback; the page's TypeScript is generated from them."""
