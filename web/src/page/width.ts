/** What there is room for across the window; the same widths stand in style/narrow.css and style/watching.css. */

/** MON 2 lies in a corner of MON 1. */
const INSET = '(width < 1100px)';
/** The arm is watched, not flown. */
const TOO_NARROW = '(width < 720px)';

export const TOO_NARROW_WORDS = 'Watching only: too narrow to fly from. Widen the window or turn the screen.';

export const inset = () => matchMedia(INSET).matches;

export const tooNarrow = () => matchMedia(TOO_NARROW).matches;

/** Tells as the window becomes too narrow to fly from, and wide enough again. */
export function onTooNarrow(changed: () => void): void {
  matchMedia(TOO_NARROW).addEventListener('change', changed);
}
