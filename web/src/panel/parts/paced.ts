/** Sends values at a limited rate. If values come faster, only the newest is sent. */

export class Paced<T> {
  private newest: { readonly value: T } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `period`: least time between two values [ms]. */
  constructor(
    private readonly period: number,
    private readonly send: (value: T) => void,
  ) {}

  /** Sends the value now or, if a period is under way, at its end. A newer value replaces one that still waits. */
  put(value: T): void {
    this.newest = { value };
    if (this.timer === undefined) this.next();
  }

  private next(): void {
    this.timer = undefined;
    if (!this.newest) return;
    const { value } = this.newest;
    this.newest = null;
    this.timer = setTimeout(() => this.next(), this.period);
    this.send(value);
  }
}
