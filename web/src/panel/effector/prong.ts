/** The concept arm's prong: its distance from the fixed finger, and its switch with three positions. */

import type { EffectorSwitch, Hand as HandState } from '../../link/protocol';
import { small } from '../../words/format';
import { button, el, setAttribute, setPressed, setText, svg } from '../parts/dom';
import { holdButton } from '../parts/hold-button';
import type { Desk } from '../parts/part';
import { CLOSE_S, type Hand, OPEN_S } from './hand';

const LENGTH = 100;

/** Returns whether the prong moves: its switch is not at stop, and it has not reached the end of its travel. */
export function isMoving({ switch: put, opening }: Pick<HandState, 'switch' | 'opening'>): boolean {
  return put !== 'stop' && opening !== (put === 'close' ? 0 : 1);
}

export function prong(desk: Desk): Hand {
  const put = (position: EffectorSwitch) => desk.send({ type: 'effector', switch: position });
  const close = holdButton('Close', 'close', CLOSE_S, () => put('close'));
  const open = holdButton('Open', 'open', OPEN_S, () => put('open'));
  const stop = button({ title: 'Stop the prong; while it moves, either key stops it too' }, ['Stop'], () =>
    put('stop'),
  );
  const keys = { close: close.element, stop, open: open.element };
  const value = el('b');
  const unit = el('span', { class: 'unit' });
  const finger = svg('rect', { class: 'pointer', x: '-2', width: '4', y: '2', height: '14' });
  const element = el(
    'div',
    { class: 'hand' },
    el(
      'div',
      { class: 'spacing' },
      el('span', {}, 'Spacing'),
      svg(
        'svg',
        { viewBox: `-4 0 ${LENGTH + 8} 18`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
        svg('rect', { class: 'track', x: '0', y: '7', width: String(LENGTH), height: '4' }),
        svg('rect', { class: 'post', x: '-3', y: '2', width: '3', height: '14' }),
        finger,
      ),
      el('span', { class: 'value' }, value, ' ', unit),
    ),
    el('div', { class: 'switch', role: 'group', 'aria-label': 'Prong' }, close.element, stop, open.element),
  );
  return {
    element,
    close,
    open,
    moves: isMoving,
    bars(hand, names) {
      close.tick(names);
      open.tick(names);
      setAttribute(finger, 'transform', `translate(${(hand.opening * LENGTH).toFixed(1)} 0)`);
    },
    set(hand, { gap }) {
      setText(value, hand.spacing === null ? '–' : small(hand.spacing, gap));
      setText(unit, gap.name);
      for (const position of ['close', 'stop', 'open'] as const) {
        setPressed(keys[position], hand.switch === position);
      }
    },
  };
}
