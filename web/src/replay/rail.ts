/** The top rail of a replay: what is played, how it was recorded, and whether it was recomputed. */

import type { PlaybackIndex, Verdict, Welcome } from '../link/protocol';
import { button, el, setClass, setText } from '../panel/parts/dom';
import { delayWords } from '../panel/rail/delays';
import type { Units } from '../words/units';

export interface ReplayRail {
  readonly element: HTMLElement;
  setVerdict(verdict: Verdict): void;
  setUnits(units: Units): void;
}

const CUT = 'The recording ends before the run did; it plays as far as it goes.';
const THINNED = 'So that the file stays small; lanes, strips and log are complete.';

/** `flying`: address of the station that plays; null: it does nothing else. */
export function replayRail(index: PlaybackIndex, flying: string | null, changeUnits: () => void): ReplayRail {
  const verdict = el('b', { role: 'status' });
  const units = button({ title: 'Change the units of the read-outs' }, [], changeUnits);
  const fact = (name: string, value: string | HTMLElement, title = '') =>
    el('span', { class: 'fact', title }, `${name} `, typeof value === 'string' ? el('b', {}, value) : value);
  /** Text of any length, cut off where the rail has no room; the tooltip has the whole text. */
  const words = (name: string, text: string) =>
    text === '' ? [] : [el('span', { class: 'fact words', title: text }, `${name} `, el('b', {}, text))];
  const note = (text: string, title: string, kind = 'note') => el('span', { class: kind, title }, text);
  const notes: HTMLElement[] = [];
  if (!index.ended) notes.push(note('Cut short', CUT, 'note caution'));
  if (index.changes.length > 0) notes.push(note('Changed', index.changes.join('\n')));
  const late = delayed(index.welcome);
  if (late) notes.push(note('Flown late', late));
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
    fact('Recomputed', verdict, 'Whether its inputs, flown anew, give the same frames.'),
    units,
    ...(flying === null ? [] : [el('a', { class: 'key', href: flying }, 'Back to flying')]),
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

/** The delays that the operator flew with; empty where there was none. */
function delayed(welcome: Welcome): string {
  const delay = (set: number) => ({ set, measured: null });
  const { label, text } = delayWords({
    command: delay(welcome.command_delay_s),
    telemetry: delay(welcome.telemetry_delay_s),
    camera: delay(welcome.camera_delay_s),
  });
  return text && `${label} ${text}. What is shown here is not delayed.`;
}

/** `2026-03-01 14:05 UTC` of an ISO time. */
export function began(iso: string): string {
  return `${iso.slice(0, 16).replace('T', ' ')} UTC`;
}

/** How often a thinned recording is drawn. */
export function drawnRate({ period_s, stride }: Pick<PlaybackIndex, 'period_s' | 'stride'>): string {
  const rate = 1 / (period_s * stride);
  if (rate < 1) return `Drawn every ${(1 / rate).toFixed(1)} s`;
  return `Drawn ${rate < 10 ? rate.toFixed(1).replace('.0', '') : Math.round(rate)} times a second`;
}
