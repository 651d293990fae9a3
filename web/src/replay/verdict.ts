/** Result of the re-simulation of a recording, which the server computes while the page plays. */

import type { Verdict } from '../link/protocol';
import type { Source } from './source';

/** Time between two requests [ms]. */
const AGAIN_MS = 1000;

/** Requests the result repeatedly until it is complete; `shown` is called with each answer. */
export function pollVerdict(source: Pick<Source, 'verdict'>, shown: (verdict: Verdict) => void): void {
  const again = () => setTimeout(() => pollVerdict(source, shown), AGAIN_MS);
  source.verdict()?.then((verdict) => {
    shown(verdict);
    if (verdict.state === 'checking') again();
  }, again);
}
