/** Frames as a station with a link sends them. */

import type { Frame, LinkSteps } from '../src/link/protocol';

/** Control period of these frames [s]. */
export const PERIOD_S = 0.1;

/** Delays that a link has, for a page that measures them. */
export const link = (telemetry_delay_s = 0, camera_delay_s = 0, command_delay_s = 0) => ({
  control_period_s: PERIOD_S,
  command_delay_s,
  telemetry_delay_s,
  camera_delay_s,
});

/** The frame of a step; `late`: delays of telemetry and pictures [steps], `began`: last step of the runs before. */
export function sent(step: number, late: readonly [number, number] = [0, 0], began = 0): Frame {
  const named: LinkSteps = { step, telemetry: step - late[0], pictures: step - late[1], cameras: [] };
  const tick = step - began;
  const display = { link: named, stick_seq: 0 };
  return { tick, time_s: PERIOD_S * tick, display, work: { clearance_level: 'info' } } as unknown as Frame;
}
