import { AgXToneMapping, NoToneMapping, PCFShadowMap, WebGLRenderer } from 'three';
import { present } from '../basics/assert';
import type { Drawing } from '../page/quality';

/** Makes the WebGL renderer of a drawing profile. Its sizes are in pixels of the screen, not in CSS px. */
export function rendererFor(
  canvas: HTMLCanvasElement,
  { quality, software }: Pick<Drawing, 'quality' | 'software'>,
): WebGLRenderer {
  const full = quality === 'full';
  const context = canvas.getContext('webgl2', {
    alpha: false, // saves the browser from blending the canvas with the page behind it
    antialias: full || !software, // without a graphics card, the low profile smooths its pictures by itself
    powerPreference: 'high-performance',
    preserveDrawingBuffer: true, // pictures that are not drawn again must stay
  });
  const renderer = new WebGLRenderer({ canvas, context: present(context, 'WebGL 2 for the pictures') });
  // Mesa's llvmpipe (LLVM 15) loops for 10 s and more in the anisotropic filtering of some pictures.
  if (software) renderer.capabilities.getMaxAnisotropy = () => 1;
  renderer.autoClear = false;
  renderer.toneMapping = full ? AgXToneMapping : NoToneMapping;
  renderer.shadowMap.enabled = full;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}
