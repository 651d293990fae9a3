/** Prepares a scene for its first picture without stopping the page: compiles shaders and loads textures. */

import {
  type Camera,
  Mesh,
  MeshStandardMaterial,
  type Scene as Stage,
  type Texture,
  type WebGLRenderer,
} from 'three';
import { expected, SIDES, SLOWEST_MS, TooSlow, type Tried } from './trial';

/** Time between two checks of the shaders [ms]. */
const CHECK_MS = 50;
/** Time between two checks of a picture [ms]. */
const LOOK_MS = 5;
/** Longest wait for the shaders [ms]; after it, the first picture waits for the rest. */
const LONGEST_MS = 60_000;

/** The part of three's program that its types leave out. */
interface Program {
  isReady?(): boolean;
}

/**
 * Prepares all shaders, textures and shapes, and tries the speed of the pictures. The renderer must not draw meanwhile.
 * Throws soon after `signal` is aborted.
 *
 * @param area area of the pictures that will be drawn [px].
 * @param progress receives the fraction that is done.
 * @throws TooSlow if these pictures would take longer than `SLOWEST_MS`.
 */
export async function prepare(
  renderer: WebGLRenderer,
  stage: Stage,
  camera: Camera,
  area: number,
  signal: AbortSignal,
  progress: (done: number) => void,
): Promise<void> {
  const textures = texturesOf(stage);
  renderer.compile(stage, camera); // starts the compilation of all shaders
  const programs = (renderer.info.programs ?? []) as readonly Program[];
  const total = textures.length + programs.length + 1;
  let loaded = 0;
  const ready = () => programs.filter((program) => program.isReady?.() ?? true).length;
  for (const texture of textures) {
    renderer.initTexture(texture);
    loaded += 1;
    progress((loaded + ready()) / total);
    await pause(signal);
  }
  for (
    const start = performance.now();
    ready() < programs.length && performance.now() - start < LONGEST_MS;
  ) {
    progress((loaded + ready()) / total);
    await pause(signal);
  }
  progress((total - 1) / total);
  await pause(signal);
  const tried: Tried[] = [];
  for (const side of SIDES) {
    renderer.setSize(side, side, false);
    renderer.shadowMap.needsUpdate = true;
    const start = performance.now();
    renderer.render(stage, camera);
    const compiles = tried.length === 0;
    await finished(renderer, start + (compiles ? LONGEST_MS : SLOWEST_MS), signal);
    tried.push({ area: side * side, ms: performance.now() - start });
  }
  const [, small, large] = tried;
  if (!small || !large) return;
  const ms = expected(small, large, area);
  if (ms > SLOWEST_MS) throw new TooSlow(ms);
}

/** Waits until the renderer has finished its picture. Throws `TooSlow` if it has not at the time `until` [ms]. */
async function finished(renderer: WebGLRenderer, until: number, signal: AbortSignal): Promise<void> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  const begun = performance.now();
  try {
    while (done && gl.clientWaitSync(done, 0, 0) === gl.TIMEOUT_EXPIRED) {
      if (performance.now() > until) throw new TooSlow(performance.now() - begun);
      await pause(signal, LOOK_MS);
    }
  } finally {
    gl.deleteSync(done);
  }
}

function texturesOf(stage: Stage): readonly Texture[] {
  const found = new Set<Texture>();
  stage.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { material } = object;
    if (!(material instanceof MeshStandardMaterial)) return;
    for (const texture of [material.map, material.bumpMap]) if (texture) found.add(texture);
  });
  return [...found];
}

async function pause(signal: AbortSignal, ms = CHECK_MS): Promise<void> {
  await new Promise((resolve) => {
    setTimeout(resolve, ms);
  });
  signal.throwIfAborted();
}
