/**
 * The opening shot at a visitor's first start: one large picture, a sentence on what this is, and one thing to do. The
 * second monitor, the desk and its numbers come when the visitor presses a key, moves a stick or gets to the second step.
 */

import type { InHand } from '../input/active-device';
import { isZero } from '../input/deflection';
import { USES } from '../input/keymap';
import type { UseInfo, Vec3, Welcome } from '../link/protocol';
import { button, el, setClass } from '../panel/parts/dom';
import type { View } from '../panel/parts/part';
import { MarkedText, type Piece } from '../task/words';
import type { Keeper } from './local-storage';
import { TOO_NARROW_WORDS } from './room';

/** Storage key: whether this browser has started the station before. Without storage, each start is the first. */
export const STARTED = 'aftdeck.started';
const WHAT = 'This is a robot arm in orbit, flown from the aft flight deck of its spacecraft.';

const OF_PICTURES: ReadonlySet<string> = new Set(['cameraStep -', 'cameraStep +', 'otherMonitor']);

/** Returns whether a run may begin with one large picture: by hand, with a task whose first step names no cameras. */
export function maySimplify({ steps, phases }: Pick<Welcome, 'steps' | 'phases'>): boolean {
  const [first] = steps;
  return first !== undefined && first.cameras.length === 0 && phases.length === 0;
}

/**
 * Returns the one thing to do, with its key and effect: the motion that reduces the largest component of the way that is
 * left, or the first function that a step names. With one picture, the keys of the cameras are no thing to begin with:
 * where a step names nothing else, there is nothing, and any key shows the desk.
 */
export function thingToDo(uses: readonly UseInfo[], way: Vec3 | null): readonly Piece[] {
  const wanted = way && largest(way);
  const others = uses.filter(({ use }) => !OF_PICTURES.has(use));
  const first = others.find(({ use }) => use === wanted) ?? others[0];
  if (!first) return [];
  const hold = USES.get(first.use)?.does.kind === 'axis';
  return [
    { kind: 'text', text: hold ? 'Now hold ' : 'Now press ' },
    { kind: 'use', text: first.use },
    { kind: 'text', text: `: ${first.does}.` },
  ];
}

/** Returns the motion of the stick that reduces the largest component: `+Z`. */
function largest(way: Vec3): string {
  const sizes = way.map(Math.abs);
  const i = sizes.indexOf(Math.max(...sizes));
  return `${(way[i] ?? 0) < 0 ? '-' : '+'}${'XYZ'[i]}`;
}

export class Opening {
  private readonly toDo: MarkedText;
  private pieces: readonly Piece[] = [];
  readonly element: HTMLElement;
  private readonly ended = new AbortController();
  /** The picture beside which the second one appears; null before the shot and after it. */
  private first: HTMLElement | null = null;

  /** `second` is the monitor that comes later. */
  constructor(
    private readonly welcome: Welcome,
    private readonly store: Keeper,
    inHand: InHand,
    private readonly second: HTMLElement,
  ) {
    this.toDo = new MarkedText(el('p', { class: 'to-do' }), inHand);
    this.element = el(
      'section',
      { class: 'opening-words', 'aria-label': 'Welcome', hidden: '' },
      el('h2', {}, WHAT),
      this.toDo.element,
      el(
        'div',
        {},
        button({}, ['Show the desk'], () => this.end()),
        el('span', {}, 'or press any key'),
      ),
    );
  }

  /** Shows one large picture if this is the browser's first start. `calm`: whether the page is calm. */
  begin(calm: boolean): void {
    const { second, store, welcome } = this;
    if (!calm || store.getItem(STARTED) !== null || !maySimplify(welcome)) return;
    this.first = second.previousElementSibling as HTMLElement | null;
    second.remove();
    this.element.hidden = false;
    setClass(document.body, 'opening', true);
    const options = { signal: this.ended.signal, capture: true };
    for (const used of ['keydown', 'pointerdown'] as const)
      document.addEventListener(used, () => this.end(), options);
  }

  /** Ends the shot when a stick is moved, the second step begins or a warning is lit, or where another page flies or this page may not. */
  values({ frame, hand, flying, flier }: View, tooNarrow: boolean, mayFly: boolean): void {
    if (!this.first) return;
    if (this.pieces.length === 0)
      this.pieces = thingToDo(this.welcome.steps[0]?.uses ?? [], frame.display.to_go?.translation ?? null);
    this.toDo.set(tooNarrow ? [{ kind: 'text', text: TOO_NARROW_WORDS }] : this.pieces);
    const { task, lamps } = frame.display;
    const alarmed = lamps.some(({ level }) => level === 'warning');
    if (!isZero(hand) || task?.at !== 0 || alarmed || (!flying && (flier !== '' || !mayFly))) this.end();
  }

  dispose(): void {
    this.ended.abort();
    setClass(document.body, 'opening', false);
  }

  /** Shows the whole page with the next picture: what the same key does comes first. */
  private end(): void {
    const { first } = this;
    if (!first) return;
    this.first = null;
    this.ended.abort();
    this.store.setItem(STARTED, 'yes');
    requestAnimationFrame(() => {
      first.after(this.second);
      this.element.hidden = true;
      setClass(document.body, 'opening', false);
    });
  }
}
