/** Functions that make values of the worksite; a test sets only the fields that it needs. */

import type { Condition, Near, ToGo, Work } from '../src/link/protocol';
import { unitsOf } from '../src/words/units';

export const [FEET, SI] = [unitsOf('ft-in'), unitsOf('SI')];

export function near(parts: Partial<Near>): Near {
  return { a: 'palm', b: 'bar', clearance: 0.3, closing: 0, essential: false, ...parts } as Near;
}

export function condition(parts: Partial<Condition>): Condition {
  const values = {
    name: 'palm height',
    unit: 'm' as const,
    value: 0,
    limit: 0.1,
    margin: 0.1,
    text: '',
    words: '',
    numbers: [],
    ...parts,
  };
  return { ...values, holds: values.margin >= 0 };
}

export function work(parts: Partial<Work>): Work {
  return { contacts: [], inhibits: [], conditions: [], cargo: [], objective: null, ...parts } as Work;
}

export function toGo(parts: Partial<ToGo>): ToGo {
  const values = { to: 'pin', translation: null, rotation: null, distance: 1, angle: 0.1 };
  return { ...values, near: [0.05, 0.05], closing: 0, shift: [0, 0, 0, 1, 0, 0, 0], ...parts };
}
