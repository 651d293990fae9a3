/** Assigns a key, button or axis to a function: waits for a press or a movement, and asks before it exchanges functions. */

import { Capture } from '../../input/capture';
import { labelOf } from '../../input/keymap';
import { nameOfSource } from '../../input/layout';
import { indexOf, type Kind, type Mapping } from '../../input/mapping';
import type { Reading } from '../../input/reading';
import { bind, exchange, keyRefusal, otherUse, type Source, unbind } from '../../input/rebind';
import { mappingOf, save } from '../../input/store';
import { button, el, setText } from '../parts/dom';

const WHILE_OPEN =
  'Sticks are centred while this sheet is open; STOP and BRAKES work. Press a cap to assign another key, button or axis.';

/** A function for which the next press or movement is awaited. */
interface Asked {
  readonly kind: Kind;
  readonly use: string;
  readonly capture: Capture;
  /** A pressed or moved source that has another function; null if there is none. */
  readonly used: Source | null;
}

export class Assignment {
  readonly element;
  private asked: Asked | null = null;
  private readonly prompt = el('p', { class: 'told', role: 'status' }, WHILE_OPEN);
  private readonly swap = button({ class: 'quiet' }, ['Exchange'], () => this.exchange());
  private readonly remove = button({ class: 'quiet' }, ['Remove'], () => this.leave());
  private readonly cancel = button({ class: 'quiet' }, ['Cancel'], () => this.end());

  /** `marked` is called with the function that waits for a press or a movement, or null. */
  constructor(private readonly marked: (use: string | null) => void) {
    this.element = el('div', { class: 'asking' }, this.prompt, this.swap, this.remove, this.cancel);
    this.show();
  }

  /** Waits for a press or movement for the function `use`; `reading`: present reading of the device. */
  ask(kind: Kind, use: string, reading: Reading | null): void {
    this.wait(kind, use, null);
    this.asked?.capture.look(reading);
    const what = kind === 'keyboard' ? 'Press the key for' : 'Press or move the control for';
    setText(this.prompt, `${what} “${labelOf(use)}”. Delete: no assignment. Esc: unchanged.`);
  }

  /** Ends the wait and displays a text. */
  end(text = WHILE_OPEN): void {
    this.asked = null;
    this.marked(null);
    setText(this.prompt, text);
    this.show();
  }

  /** Assigns a pressed key if a key is awaited; returns whether it has used the key. */
  taken(event: KeyboardEvent): boolean {
    if (!this.asked) return false;
    if (event.repeat) return true;
    if (event.code === 'Escape') this.end();
    else if (event.code === 'Delete') this.leave();
    else if (this.asked.kind === 'keyboard') {
      const refusal = keyRefusal(event);
      if (refusal === null) this.take({ source: event.code, sign: 1 });
      else setText(this.prompt, refusal);
    } else return false;
    return true;
  }

  /** Assigns a button or axis that was pressed or moved. */
  look(reading: Reading | null): void {
    if (!this.asked || this.asked.kind === 'keyboard') return;
    const found = this.asked.capture.look(reading);
    if (found) this.take(found);
  }

  private take(source: Source): void {
    if (!this.asked) return;
    const { kind, use, used } = this.asked;
    const mapping = mappingOf(kind);
    const again = source.source === used?.source;
    if (again && indexOf(source.source, 'a') !== null)
      this.wait(kind, use, used); // the axis returns to its centre
    else if (again) this.exchange();
    else if (otherUse(mapping, use, source) === null) this.store(() => bind(kind, mapping, use, source));
    else this.offer(source, () => exchange(kind, mapping, use, source));
  }

  /** Offers to exchange the functions, if this is possible. */
  private offer(source: Source, attempt: () => Mapping): void {
    if (!this.asked) return;
    const { kind, use } = this.asked;
    const other = otherUse(mappingOf(kind), use, source) ?? '';
    try {
      attempt();
    } catch (error) {
      this.refuse(error);
      return;
    }
    this.wait(kind, use, source);
    const axis = indexOf(source.source, 'a') !== null;
    const name = nameOfSource(kind, source.source);
    const how = axis ? 'Exchange' : 'Exchange, or the same again,';
    setText(
      this.prompt,
      `${name} is already “${labelOf(other)}”. ${how} gives it the former control of “${labelOf(use)}”.`,
    );
  }

  private exchange(): void {
    if (!this.asked?.used) return;
    const { kind, use, used } = this.asked;
    this.store(() => exchange(kind, mappingOf(kind), use, used));
  }

  private store(change: () => Mapping): void {
    if (!this.asked) return;
    const { kind, use } = this.asked;
    try {
      const kept = save(kind, change());
      this.end(
        `“${labelOf(use)}” is assigned, ${kept ? 'and stored in this browser' : 'but this browser cannot store it'}.`,
      );
    } catch (error) {
      this.refuse(error);
    }
  }

  private refuse(error: unknown): void {
    if (!this.asked) return;
    this.wait(this.asked.kind, this.asked.use, null);
    setText(this.prompt, error instanceof Error ? error.message : String(error));
  }

  private leave(): void {
    if (!this.asked) return;
    const { kind, use } = this.asked;
    save(kind, unbind(mappingOf(kind), use));
    this.end(`“${labelOf(use)}” is no longer assigned on this device.`);
  }

  private wait(kind: Kind, use: string, used: Source | null): void {
    this.asked = { kind, use, used, capture: new Capture(mappingOf(kind)) };
    this.marked(use);
    this.show();
  }

  private show(): void {
    this.cancel.hidden = this.remove.hidden = this.asked === null;
    this.swap.hidden = !this.asked?.used;
  }
}
