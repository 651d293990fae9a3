/** Directions from which the engineering view can show the subjects of the work. */

import type { Vec3 } from '../link/protocol';
import type { Placed } from '../scene/orbit';
import type { Found } from './subjects';

/** Azimuths and elevations that are tried [rad]; the last elevation looks almost straight down. */
const HEADINGS = Array.from({ length: 12 }, (_, i) => (i * Math.PI) / 6);
const RISES = [0.25, 0.6, 1, 1.4] as const;
/** Part of the picture that the subjects fill, and the least distance [m]. */
const [FILLED, LEAST_M] = [0.6, 7];

/** Returns views from all directions, at a distance at which all subjects are in the picture. */
export function orbitsAround(found: readonly Found[], angle: number): readonly Placed[] {
  if (found.length === 0) return [];
  const centre = [0, 1, 2].map((k) => {
    const values = found.map(({ place }) => place[k] ?? 0);
    return (Math.min(...values) + Math.max(...values)) / 2;
  }) as unknown as Vec3;
  const reach = Math.max(
    ...found.map(
      ({ place, diameter }) => diameter / 2 + Math.hypot(...place.map((v, k) => v - (centre[k] ?? 0))),
    ),
  );
  const distance = Math.max(LEAST_M, reach / (FILLED * Math.tan(angle / 2)));
  return HEADINGS.flatMap((heading) => RISES.map((rise) => ({ centre, distance, heading, rise })));
}
