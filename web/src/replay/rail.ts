/** The top rail of a replay: the recording, its conditions, and the result of its re-simulation. */

import type { PlaybackIndex, Verdict, Welcome } from '../link/protocol';
import { button, el, setClass, setText } from '../panel/parts/dom';
import { delayWords } from '../panel/rail/delays';
import type { Units } from '../words/units';

export interface ReplayRail {
  readonly element: HTMLElement;
  setVerdict(verdict: Verdict): void;
  setUnits(units: Units): void;
}

const CUT = 'The recording ends before the end of the run; it plays up to its last frame';
const THINNED =
  'To stay small, the file contains only some of the frames; lanes, strips and log are complete';

/** `flying`: address of the station with the present run; null if there is none. */
export function replayRail(index: PlaybackIndex, flying: string | null, changeUnits: () => void): ReplayRail {
  const verdict = el('b', { role: 'status' });
  const units = button({ title: 'Change the units of the read-outs' }, [], changeUnits);
  const fact = (name: string, value: string | HTMLElement, title = '') =>
    el('span', { class: 'fact', title }, `${name} `, typeof value === 'string' ? el('b', {}, value) : value);
  /** Makes an element for a fact with a long text. If the text does not fit, it is cut; the tooltip has all of it. */
  const words = (name: string, text: string) =>
    text === '' ? [] : [el('span', { class: 'fact words', title: text }, `${name} `, el('b', {}, text))];
  const note = (text: string, title: string, kind = 'note') => el('span', { class: kind, title }, text);
  const notes: HTMLElement[] = [];
  if (!index.ended) notes.push(note('Cut short', CUT, 'note caution'));
  if (index.changes.length > 0) notes.push(note('Changed', index.changes.join('\n')));
  const late = delayed(index.welcome);
  if (late) notes.push(note('Delayed', late));
  if (index.stride > 1) notes.push(note(drawnRate(index), THINNED));
  const element = el(
    'header',
    { class: 'rail' },
    el('h1', {}, 'Aftdeck'),
    el('b', { class: 'replay-tag' }, 'Replay'),
    el('span', { class: 'file', title: index.file }, index.file),
    el('span', { class: 'scenario', title: index.welcome.text }, index.welcome.title),
    el('span', { class: 'space' }),
    ...notes,
    ...words('Participant', index.participant),
    ...words('Condition', index.condition),
    fact('Recorded', began(index.began), `Aftdeck ${index.version}, seed ${index.seed}`),
    fact('Re-simulated', verdict, 'Result of re-simulating the recorded inputs'),
    units,
    ...(flying === null ? [] : [el('a', { class: 'key', href: flying }, 'Back to flight')]),
  );
  return {
    element,
    setVerdict({ state, text }) {
      setText(verdict, text);
      setClass(verdict, 'equal', state === 'equal');
      setClass(verdict, 'caution', state === 'different' || state === 'impossible');
    },
    setUnits: ({ name }) => setText(units, name === 'SI' ? 'SI' : 'ft · in'),
  };
}

/** Returns a text with the delays of the run; empty if there were none. */
function delayed(welcome: Welcome): string {
  const delay = (set: number) => ({ set, measured: null });
  const { label, text } = delayWords({
    command: delay(welcome.command_delay_s),
    telemetry: delay(welcome.telemetry_delay_s),
    camera: delay(welcome.camera_delay_s),
  });
  return text && `${label} ${text}. The replay is not delayed`;
}

/** Returns an ISO time in the form `2026-03-01 14:05 UTC`. */
export function began(iso: string): string {
  return `${iso.slice(0, 16).replace('T', ' ')} UTC`;
}

/** Returns a text with the rate of the frames in a thinned recording. */
export function drawnRate({ period_s, stride }: Pick<PlaybackIndex, 'period_s' | 'stride'>): string {
  const rate = 1 / (period_s * stride);
  if (rate < 1) return `Drawn every ${(1 / rate).toFixed(1)} s`;
  return `Drawn ${rate < 10 ? rate.toFixed(1).replace('.0', '') : Math.round(rate)} times a second`;
}
