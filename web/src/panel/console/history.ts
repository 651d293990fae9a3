/** Lines typed before, which the arrow keys bring back. */
export class History {
  private readonly lines: string[] = [];
  private at = 0;

  add(line: string): void {
    if (line !== '' && line !== this.lines.at(-1)) this.lines.push(line);
    this.at = this.lines.length;
  }

  /** Returns the line before (-1) or after (1) the one shown; empty after the last one. */
  step(by: -1 | 1): string {
    this.at = Math.min(Math.max(this.at + by, 0), this.lines.length);
    return this.lines[this.at] ?? '';
  }
}

/** Returns the text with which all words begin. */
export function common(words: readonly string[]): string {
  const [first = '', ...others] = words;
  let length = first.length;
  while (length > 0 && !others.every((word) => word.startsWith(first.slice(0, length)))) length -= 1;
  return first.slice(0, length);
}

/** Returns a line whose last word is replaced. */
export function completed(line: string, word: string): string {
  return line.replace(/[^\s;=]*$/, word);
}
