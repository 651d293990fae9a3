/** Active limits, and the escape directions of joints that have reached a limit. */

import type { Names } from '../../input/active-device';
import type { Frame, Limit, WayOut } from '../../link/protocol';
import { capitalised } from '../../words/format';
import { spoken, wayOutText } from '../../words/way-out';
import { el, group, setAbout } from '../parts/dom';
import type { Desk, Part } from '../parts/part';

const LINES = 3;
/** A limit stays visible for this time after it was active [s]. */
const HOLD_S = 0.6;

interface Line {
  readonly text: string;
  readonly level: 'caution' | 'info';
}

export function limits({ welcome }: Desk): Part {
  const list = el('ul', { class: 'acting' });
  const element = group('limits', 'Limits', list);
  const joints = new Set(welcome.joints.map(({ name }) => name));
  const seen = new Map<string, { readonly at: number; readonly kind: Limit['kind'] }>();
  let shown = '-';

  const remember = (frame: Frame) => {
    for (const { text, kind } of frame.limits) seen.set(text, { at: frame.time_s, kind });
    for (const [text, { at }] of seen) {
      if (frame.time_s - at > HOLD_S || at > frame.time_s) seen.delete(text);
    }
  };
  return {
    element,
    bars: ({ frame }) => remember(frame),
    values({ frame, controllers: { names } }) {
      const acting = [...seen].map(([text, { kind }]): Line => ({ text, level: level(kind) }));
      const ways = frame.ways_out
        .filter(({ cause }) => joints.has(cause))
        .map((way): Line => ({ text: leadsAway(way, names), level: 'caution' }));
      const all = [
        ...acting.filter((line) => line.level === 'caution'),
        ...ways,
        ...acting.filter((line) => line.level === 'info'),
      ];
      const rest = all.length - LINES;
      const lines: Line[] = rest > 0 ? all.slice(0, LINES - 1) : all;
      if (rest > 0) lines.push({ text: `and ${rest + 1} more`, level: 'info' });
      setAbout(element, acting.length > 0 ? 'active' : ways.length > 0 ? 'escape' : '');
      const key = lines.map((line) => `${line.level} ${line.text}`).join('\n');
      if (key === shown) return;
      shown = key;
      const items = lines.map((line) =>
        el(
          'li',
          { class: line.level },
          el('i', { class: 'sign' }),
          el('span', { title: line.text }, line.text),
        ),
      );
      if (items.length === 0) items.push(el('li', { class: 'none' }, 'None active'));
      list.replaceChildren(...items);
    },
  };
}

/** `Elbow pitch: THC +Z leads away`, or `Elbow pitch: SINGLE − leads away`. */
export function leadsAway(way: WayOut, names: Names): string {
  const name = spoken(way.cause);
  return `${capitalised(name)}: ${wayOutText(way, '', names)} leads away`;
}

/** Returns the level of a limit: info for the POR limits, which are active in every motion; caution for all others. */
function level(kind: Limit['kind']): Line['level'] {
  switch (kind) {
    case 'POR translation':
    case 'POR rotation':
    case 'POR acceleration':
      return 'info';
    case 'joint rate':
    case 'joint acceleration':
    case 'soft stop':
    case 'hard stop':
    case 'singularity':
    case 'seat':
    case 'contact':
    case 'switch':
      return 'caution';
  }
}
