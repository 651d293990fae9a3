/** The tutorial: six steps of a first capture in a separate scenario. A step ends when the operator has done it. */

import type { InHand } from '../input/active-device';
import type { Action } from '../input/keymap';
import { revision } from '../input/store';
import type { Frame } from '../link/protocol';
import { keeper } from '../page/local-storage';
import { button, setAttribute, setClass, setPressed } from '../panel/parts/dom';
import type { Desk, View } from '../panel/parts/part';
import type { Units } from '../words/units';
import { Card } from './card';
import { BEGIN, back, looked, type Progress, seen, skip } from './progress';
import { STEPS } from './steps';

/** Built-in scenario of the tutorial, and the mode that its steps need. */
export const SCENARIO = 'tutorial';
const MODE = 'END EFF';
/** Storage key: whether the tutorial was opened before. Without storage, the guide opens at each visit. */
const KEY = 'aftdeck.tutorial';
const OPENED = 'opened';
const LOOKS: ReadonlySet<Action['name']> = new Set([
  'camera',
  'cameraStep',
  'otherMonitor',
  'split',
  'matrix',
]);

export class Tutorial {
  /** Button in the rail: loads the tutorial's scenario, or opens and closes the guide in it. */
  readonly key: HTMLButtonElement;
  private readonly card: Card;
  private readonly ended = new AbortController();
  private readonly payload: number;
  private progress: Progress = BEGIN;
  private open = false;
  /** Whether the card opens by itself as soon as this page is in control. */
  private unasked: boolean;
  private drawn = '';

  constructor(
    private readonly desk: Desk,
    private readonly inHand: InHand,
    private readonly flyIt: (scenario: string) => void,
  ) {
    const { welcome } = desk;
    this.unasked = this.offered && keeper.getItem(KEY) !== OPENED;
    const name = this.offered ? 'Guide' : 'Tutorial';
    this.key = button({ title: 'Learn a first capture in six steps' }, [name], () => this.toggle());
    this.payload = welcome.bodies.findIndex(({ name }) => name === welcome.work.cargo[0]);
    this.card = new Card(this.inHand, {
      back: () => this.go(back(this.progress)),
      skip: () => this.go(skip(this.progress)),
      close: () => this.show(false),
      enterMode: () => desk.send({ type: 'enter_mode', mode: MODE }),
    });
    this.show(false);
    const clicked = ({ target }: Event) => {
      if (target instanceof Element && target.closest('.monitor button'))
        this.progress = looked(this.progress);
    };
    document.addEventListener('click', clicked, { signal: this.ended.signal });
  }

  get element(): HTMLElement {
    return this.card.element;
  }

  /**
   * Called when the user chooses a scenario. For the tutorial's scenario, the guide opens: at once if this scenario
   * is already loaded, otherwise after it has been loaded.
   */
  chosen(scenario: string): void {
    if (scenario !== SCENARIO) return;
    if (this.offered) this.show(true);
    else keeper.setItem(KEY, 'asked');
  }

  /** Called for each action of the operator. */
  acted({ name }: Action): void {
    if (LOOKS.has(name)) this.progress = looked(this.progress);
  }

  values({ frame, flying, units }: View): void {
    if (this.unasked && flying) this.show(true);
    if (!this.open) return;
    this.progress = seen(this.progress, frame, frame.display.poses[7 * this.payload + 2] ?? 0);
    this.draw(frame, units);
  }

  light(): void {
    if (this.open) this.card.light();
  }

  dispose(): void {
    this.ended.abort();
    this.show(false);
  }

  private get offered(): boolean {
    return this.desk.welcome.scenario === SCENARIO;
  }

  private toggle(): void {
    if (this.offered) this.show(!this.open);
    else this.flyIt(SCENARIO);
  }

  private go(progress: Progress): void {
    this.progress = progress;
  }

  private show(open: boolean): void {
    if (open) {
      this.progress = BEGIN;
      this.unasked = false;
      keeper.setItem(KEY, OPENED);
    }
    this.open = open;
    this.card.element.hidden = !open;
    if (this.offered) setPressed(this.key, open);
    setClass(document.body, 'guided', open);
  }

  private draw(frame: Frame, units: Units): void {
    const { progress } = this;
    const step = STEPS[progress.at];
    const caps = step?.caps(frame) ?? [];
    const drawn = `${progress.at} ${caps.join()} ${this.inHand.kinds.join()} ${revision()}`;
    if (drawn !== this.drawn) {
      this.drawn = drawn;
      this.card.setCaps(caps);
      setAttribute(document.body, 'data-step', step?.groups.join(' ') ?? '');
    }
    const astray = frame.mode === MODE ? '' : frame.mode;
    if (step) this.card.set(progress, step.words(frame, units), step.title, astray);
    else {
      const [title, words] = farewell(progress.flown);
      this.card.set(progress, words, title, astray);
    }
  }
}

/**
 * Returns the closing title and text; `flown`: time at which all steps were complete and the payload was free [s];
 * null if this is not so yet.
 */
export function farewell(flown: number | null): readonly [title: string, words: string] {
  if (flown === null)
    return [
      'Not complete yet',
      'These were all the steps, but the payload is still in the bay. Go back to a skipped step, or press *Restart* ' +
        'to begin again.',
    ];
  const [minutes, seconds] = [Math.floor(flown / 60), Math.floor(flown % 60)];
  const took = minutes > 0 ? `${minutes} min ${seconds} s` : `${seconds} s`;
  return [
    'Complete',
    `The payload is captured and out of its latches, ${took} after the start. Close the guide and continue: rotate, berth and ` +
      'release the payload. *Keys ?* shows all keys; *Restart* begins again.',
  ];
}
