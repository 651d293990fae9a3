/** REC with the elapsed time of the recording, and below it a list of the station's recordings with links. */

import type { Frame, Recorded } from '../../link/protocol';
import { clock } from '../../words/format';
import { el, setClass, setText } from '../parts/dom';
import { dropDown } from '../parts/drop-down';

export interface RecordingsControl {
  readonly element: HTMLElement;
  values(frame: Frame): void;
  close(): void;
}

export function recordings(): RecordingsControl {
  const running = el('b');
  const rows = el('div', {}, el('p', {}, 'Loading the list.'));
  const list = el(
    'div',
    { class: 'choices recordings', role: 'group', 'aria-label': 'Recordings' },
    el('h3', {}, 'Replay'),
    rows,
  );
  const drop = dropDown('REC ', TITLE, list);
  drop.key.append(running);
  drop.element.classList.add('rec');
  drop.key.addEventListener('click', () => {
    if (drop.isOpen) show().catch((error: unknown) => rows.replaceChildren(el('p', {}, `${error}`)));
  });

  async function show(): Promise<void> {
    const answer = await fetch('recordings.json');
    if (!answer.ok) throw new Error(`The station does not list its recordings: ${answer.status}`);
    const all: readonly Recorded[] = await answer.json();
    rows.replaceChildren(...all.map(row), ...(all.length === 0 ? [el('p', {}, 'No recordings yet.')] : []));
  }

  return {
    element: drop.element,
    values({ display: { recording_s } }) {
      setClass(drop.element, 'absent', recording_s === null);
      setText(running, clock(recording_s ?? 0));
    },
    close() {
      drop.open(false);
    },
  };
}

function row(run: Recorded): HTMLElement {
  const { file, changed, now, title } = run;
  const when = new Date(changed).toLocaleString(undefined, { dateStyle: 'short', timeStyle: 'short' });
  return el(
    'a',
    { href: `replay/${encodeURIComponent(file)}/`, title: now ? SO_FAR : file },
    el('b', {}, title || file.replace(/\.mcap$/, '')),
    el('small', {}, resultWords(run)),
    el('small', {}, now ? 'this run so far' : when),
  );
}

/** Ends of a run as the list shows them; a run that the operator stopped or restarted has only its length. */
const ENDS: Readonly<Record<string, string>> = {
  completed: 'completed',
  time: 'time is up',
  fault: 'fault',
  cut: 'cut short',
};

/** Returns length, end and grade of a run: `4:05, completed, grade A`. */
export function resultWords({ time_s, ended, grade }: Pick<Recorded, 'time_s' | 'ended' | 'grade'>): string {
  if (time_s === null) return '';
  const [minutes, seconds] = [Math.floor(time_s / 60), String(Math.floor(time_s % 60)).padStart(2, '0')];
  const graded = grade === '' ? '' : `grade ${grade}`;
  return [`${minutes}:${seconds}`, ENDS[ended] ?? '', graded].filter((word) => word !== '').join(', ');
}

const TITLE = 'Open a replay of this run or of an earlier one';
const SO_FAR = 'Open the replay; meanwhile the run continues unattended';
