/** Splits a text with marks into pieces: `{+X}` stands for a key or a stick, `*RIGID*` quotes a text on the desk. */

export interface Piece {
  readonly kind: 'text' | 'use' | 'shown';
  readonly text: string;
}

export function pieces(words: string): readonly Piece[] {
  return words
    .split(/(\{[^}]+\}|\*[^*]+\*)/)
    .filter((part) => part !== '')
    .map((part) => {
      if (part.startsWith('{')) return { kind: 'use', text: part.slice(1, -1) };
      if (part.startsWith('*')) return { kind: 'shown', text: part.slice(1, -1) };
      return { kind: 'text', text: part };
    });
}
