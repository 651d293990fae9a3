/** A value, held between two others. */
export function clamp(value: number, least = -1, greatest = 1): number {
  return Math.max(least, Math.min(greatest, value));
}
