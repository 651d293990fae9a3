/** Prepares a scene for its first picture without stopping the page: compiles shaders and loads textures. */

import {
  type Camera,
  Mesh,
  MeshStandardMaterial,
  type Scene as Stage,
  type Texture,
  type WebGLRenderer,
} from 'three';

/** Time between two checks of the shaders [ms]. */
const CHECK_MS = 50;
/** Longest wait for the shaders [ms]; after it, the first picture waits for the rest. */
const LONGEST_MS = 60_000;
/** Size of the picture that loads the shapes [px]. */
const SMALL = 16;

/** The part of three's program that its types leave out. */
interface Program {
  isReady?(): boolean;
}

/**
 * Prepares all shaders, textures and shapes; `progress` receives the fraction that is done. The renderer must not draw
 * meanwhile. Throws soon after `signal` is aborted.
 */
export async function prepare(
  renderer: WebGLRenderer,
  stage: Stage,
  camera: Camera,
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
  renderer.setSize(SMALL, SMALL, false);
  renderer.shadowMap.needsUpdate = true;
  renderer.render(stage, camera);
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

async function pause(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => {
    setTimeout(resolve, CHECK_MS);
  });
  signal.throwIfAborted();
}
