/** Positions in a pixel at which a still picture is drawn. The mean of these pictures has smooth edges. */

/** The standard pattern of eight samples of Direct3D 11 (`D3D11_STANDARD_MULTISAMPLE_PATTERN`) [px from the middle]. */
export const SAMPLES: readonly (readonly [number, number])[] = (
  [
    [1, -3],
    [-1, 3],
    [5, 1],
    [-3, -5],
    [-5, 5],
    [-7, -1],
    [3, 7],
    [7, -7],
  ] as const
).map(([x, y]) => [x / 16, y / 16]);
