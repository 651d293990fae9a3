/**
 * The calm page: it shows only the parts that the task's steps so far and the state of the run have needed. The key
 * *Full panel* shows all parts; the browser keeps this choice. A scenario without steps always has the full panel.
 */

import type { ModeInfo, Welcome } from '../../link/protocol';
import type { Keeper } from '../../page/local-storage';
import { button, setClass, setPressed, setText } from '../parts/dom';
import type { View } from '../parts/part';
import { type Situation, situationNeeds, stepNeeds, useNeeds } from './needs';

const KEPT = 'aftdeck.panel';
const FULL = 'full';

/** What the page shows beside a frame. */
interface Shown extends Pick<Situation, 'lamps' | 'cameras'> {
  /** The selected position of the rotary, or the entered position if none is selected. */
  readonly selected: ModeInfo | undefined;
}

export class Calm {
  /** Button in the rail. */
  readonly key = button({ title: ABOUT, 'aria-label': 'Full panel' }, [], () => this.toggle());
  private full: boolean;
  /** What each step needs. */
  private readonly bySteps: readonly (readonly string[])[];
  /** What has been needed since the run began. */
  private readonly needed = new Set<string>();
  private time = 0;
  private parts: readonly HTMLElement[] = [];

  constructor(
    private readonly welcome: Welcome,
    private readonly store: Keeper,
  ) {
    this.full = store.getItem(KEPT) === FULL;
    this.bySteps = welcome.steps.map(stepNeeds);
    this.key.hidden = welcome.steps.length === 0;
  }

  values({ frame, orbiting }: View, { lamps, selected, cameras }: Shown): void {
    if (frame.time_s < this.time) this.needed.clear(); // the run was restarted
    this.time = frame.time_s;
    const modes = [this.welcome.modes.find(({ position }) => position === frame.mode), selected];
    const holding = frame.work.cargo.some(({ held }) => held);
    const past = this.bySteps.slice(0, (frame.display.task?.at ?? 0) + 1);
    for (const needs of [...past, situationNeeds({ lamps, modes, cameras, holding, orbiting })])
      for (const name of needs) this.needed.add(name);
    this.draw();
  }

  /** Shows the parts of a function, because the operator has pressed its key. */
  use(name: string): void {
    for (const need of useNeeds(name)) this.needed.add(need);
    this.draw();
  }

  /** Whether the page is calm. */
  get on(): boolean {
    return !this.full && this.welcome.steps.length > 0;
  }

  /** Finds the parts that need a reason to be shown; called while all of them are in the document. */
  gather(): void {
    this.parts = [...document.querySelectorAll<HTMLElement>('[data-calm]')];
  }

  private draw(): void {
    const calm = this.on;
    if (this.parts.length === 0) this.gather();
    setPressed(this.key, this.full);
    setText(this.key, this.full ? 'Full' : 'Full panel'); // the rail of the full panel has less room
    setClass(document.body, 'calm', calm);
    for (const part of this.parts) {
      const { classList, ariaPressed } = part;
      const set = ariaPressed === 'true' || classList.contains('turned');
      setClass(part, 'unneeded', calm && !set && !this.needed.has(part.getAttribute('data-calm') ?? ''));
    }
  }

  private toggle(): void {
    this.full = !this.full;
    this.store.setItem(KEPT, this.full ? FULL : '');
    this.draw();
  }
}

const ABOUT = 'Show all controls and read-outs, or only those that the task has needed so far';
