/** Hands on the newest of many values, no more often than a link should carry them. */

export class Paced<T> {
  private newest: { readonly value: T } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `period` between two values [ms]. */
  constructor(
    private readonly period: number,
    private readonly send: (value: T) => void,
  ) {}

  /** Sends the value now, or as soon as the last one is old enough, unless a newer one comes. */
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
