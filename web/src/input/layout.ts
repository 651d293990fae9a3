/** The letters on the user's own keyboard, where the browser tells them; keys go by their place. */

const NAMES: Readonly<Record<string, string>> = {
  Space: 'Space',
  Enter: 'Enter',
  Minus: '−',
  Equal: '=',
  BracketLeft: '[',
  BracketRight: ']',
  Comma: ',',
  Period: '.',
  Backquote: '`',
  Semicolon: ';',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  PageUp: 'Page ↑',
  PageDown: 'Page ↓',
};

let letters: ReadonlyMap<string, string> = new Map();

/** What stands on the key at that place, as far as it is known now. */
export function nameOf(code: string): string {
  return NAMES[code] ?? letters.get(code)?.toUpperCase() ?? code.replace(/^(Key|Digit)/, '');
}

/** Asks the browser once; afterwards `nameOf` knows. */
export async function learnLayout(): Promise<void> {
  const { keyboard } = navigator as Navigator & {
    keyboard?: { getLayoutMap(): Promise<ReadonlyMap<string, string>> };
  };
  letters = (await keyboard?.getLayoutMap().catch(() => undefined)) ?? letters;
}
