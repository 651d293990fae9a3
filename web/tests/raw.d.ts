/** Text of a file, which Vite imports with `?raw`. */
declare module '*?raw' {
  const text: string;
  export default text;
}
