/** Offers another pair of cameras when the situation changes: a new task phase, capture, release, berth or near goal. */

import type { ClosestPoints, Frame } from '../link/protocol';
import { ACTIVITIES } from '../words/task-phases';

export interface PairOffer {
  /** Names of the cameras for MON 1 and MON 2. */
  readonly cameras: readonly [string, string];
  /** Reason for the offer, in a few words: `extraction`. */
  readonly why: string;
}

/** Returns a text that changes with the situation. */
export function situationOf({ work }: Frame, gap: ClosestPoints | null): string {
  const payloads = work.cargo.map(({ name, held, seat }) => `${name} ${held} ${seat}`);
  return [work.task, work.objective?.action ?? '', gap !== null, ...payloads].join();
}

/** Returns the name of the situation: the action that becomes possible, or else the task phase. */
export function situationWords({ work }: Frame): string {
  return (
    work.objective?.text ?? (work.cargo.length > 0 ? ACTIVITIES[work.task - 1] : undefined) ?? 'clearance'
  );
}

/** Counts surveys after a change of situation: the cameras are surveyed one after the other, one for each drawing. */
export class SituationWatch {
  private situation: string | null = null;
  private left = 0;

  constructor(private readonly cameras: number) {}

  /** Whether surveys are pending. */
  get pending(): boolean {
    return this.left > 0;
  }

  /** Stores the situation at a drawing. A change starts the surveys again; the first situation starts none. */
  see(situation: string): void {
    if (this.situation !== null && situation !== this.situation) this.left = this.cameras;
    this.situation = situation;
  }

  /** Counts one survey; returns whether it was the last one. */
  surveyed(): boolean {
    this.left -= 1;
    return this.left === 0;
  }
}
