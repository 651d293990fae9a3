/** The MODE rotary: twelve positions, and MASTER if the arm has this mode. A position is selected, then entered. */

import { button, el, setAttribute, setClass, setPressed } from '../parts/dom';
import type { Desk } from '../parts/part';

export interface Rotary {
  readonly element: HTMLElement;
  /** The selected position, or the entered position if none is selected. */
  shown(): string;
  /** Sets the position that the station has entered; `grasping`: a payload is captured. */
  set(position: string, grasping: boolean): void;
  turn(by: number): void;
  /** Enters the selected position; returns whether one was selected. */
  enter(): boolean;
}

export function rotary(desk: Desk): Rotary {
  const { modes } = desk.welcome;
  let entered = '';
  let turned: string | null = null;

  const enter = () => {
    if (turned !== null) desk.send({ type: 'enter_mode', mode: turned });
    return turned !== null;
  };
  const turnTo = (position: string) => {
    turned = position === entered ? null : position;
    draw();
  };
  const keys = modes.map(({ position, kind }) => {
    const key = button({ 'data-calm': `mode ${position}` }, [el('i', { class: 'dot' }), position], () => {
      if (turned === position) enter();
      else turnTo(position);
    });
    setClass(key, 'thirteenth', kind === 'master');
    return key;
  });
  const element = el('div', { class: 'rotary', role: 'group', 'aria-label': 'Mode' }, ...keys);
  setClass(
    element,
    'with-master',
    modes.some(({ kind }) => kind === 'master'),
  );

  function draw(): void {
    modes.forEach(({ position }, i) => {
      const key = keys[i];
      if (!key) return;
      setPressed(key, position === entered);
      setClass(key, 'turned', position === turned);
    });
  }

  return {
    element,
    shown: () => turned ?? entered,
    set(position, grasping) {
      modes.forEach(({ title, point, enabled }, i) => {
        const key = keys[i];
        if (!key) return;
        const missing = point === 'payload' ? 'needs a captured payload' : 'no points are stored';
        const there = enabled && (grasping || point !== 'payload');
        setClass(key, 'absent', !there);
        setAttribute(key, 'title', there ? title : `${title}: ${missing}`);
      });
      if (position !== entered) turned = null;
      entered = position;
      draw();
    },
    turn(by) {
      const at = modes.findIndex(({ position }) => position === (turned ?? entered));
      turnTo(modes[(at + by + modes.length) % modes.length]?.position ?? entered);
    },
    enter,
  };
}
