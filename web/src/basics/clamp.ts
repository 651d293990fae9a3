/** Returns the value, limited to the range from `least` to `greatest`. */
export function clamp(value: number, least = -1, greatest = 1): number {
  return Math.max(least, Math.min(greatest, value));
}
