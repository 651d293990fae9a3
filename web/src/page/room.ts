/** Named conditions on the size of the page, or of a part, for code and for `@container page (--NAME)` in the style sheets. */

export const ROOM = {
  /** MON 2 is in a corner of MON 1, and the desk has more rows. */
  inset: '(width < 1280px)',
  /** The desk's two tables are side by side in a row that contains nothing else. */
  upright: '(width < 956px)',
  /** The names of the cameras are close together. */
  slender: '(width < 768px)',
  /** The page can only observe. */
  watching: '(width < 720px)',
  /** Lamps are in two columns. */
  low: '((height < 860px) or ((width < 956px) and (height < 1020px)))',
  /** A replay shows either the figures of the run or its log. */
  short: '(height <= 870px)',
  /** A lamp's small text has only one line. */
  shallow: '(height <= 809px)',
  /** The page scrolls, because the window is lower than the desk with the least pictures. */
  sunk: '(height < 720px)',
  /** The rest of the guide's card, below its instruction, has no room for a note. */
  full: '(height < 1.6rem)',
} as const;

export const TOO_NARROW_WORDS =
  'Observing only: the window is too narrow for the controls. Widen it or rotate the screen.';

export const inset = () => matchMedia(ROOM.inset).matches;

export const tooNarrow = () => matchMedia(ROOM.watching).matches;

/** Calls `changed` when the window becomes too narrow for the controls, and when it is wide enough again. */
export function onTooNarrow(changed: () => void): void {
  matchMedia(ROOM.watching).addEventListener('change', changed);
}
