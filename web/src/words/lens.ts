/** A camera's lens and drives as text in its picture. */

import type { Camera, Travel, Vec3 } from '../link/protocol';
import { degrees } from './format';

/**
 * An angle this close to the end of its travel [rad] counts as at its stop. Rounding errors in messages are smaller
 * than this.
 */
const AT_STOP = 2e-6;

/** `PAN −8.6  TILT +6.8` over `ZOOM 22 %  FOV 62.0°`; a value at its stop is marked. */
export function lensWords(camera: Camera, setting: Vec3 | null): string {
  const { drive, kind } = camera;
  if (kind === 'engineering') return 'FREE VIEW  drag or arrows';
  if (!drive || !setting) {
    return `${kind === 'window' ? 'WINDOW' : 'FIXED'}  FOV ${degrees(camera.field_of_view, 1, false)}°`;
  }
  const [pan, tilt, angle] = setting;
  const turned = [
    ...(drive.pan ? [`PAN ${degrees(pan)}${stop(drive.pan, pan)}`] : []),
    ...(drive.tilt ? [`TILT ${degrees(tilt)}${stop(drive.tilt, tilt)}`] : []),
  ].join('  ');
  const wide = `FOV ${degrees(angle, 1, false)}°`;
  const lens = drive.zoom ? `ZOOM ${Math.round(100 * zoomed(drive.zoom, angle))} %  ${wide}` : wide;
  return `${turned || 'FIXED'}\n${lens}`;
}

/** Zoom as a fraction of its range: 0 at the widest field of view, 1 at the narrowest. */
export function zoomed({ least, greatest }: Travel, angle: number): number {
  return (greatest - angle) / (greatest - least);
}

function stop({ least, greatest }: Travel, angle: number): string {
  return angle < least + AT_STOP || angle > greatest - AT_STOP ? ' STOP' : '';
}
