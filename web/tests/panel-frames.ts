import type { Frame } from '../src/link/protocol';

/** Frames with only the fields that a test needs. */

const still = { velocity: [0, 0, 0], turn_rate: [0, 0, 0] };
const moving = { velocity: [0.1, -0.3, 0], turn_rate: [0, 0, 0.01] };

export function frameOf(parts: object): Frame {
  const display = { actual: still, commanded: moving };
  return { limits: [], por_limits: [0.6, 0.08], display, ...parts } as never;
}
