import { AgXToneMapping, NoToneMapping, PCFShadowMap, WebGLRenderer } from 'three';
import { present } from '../basics/assert';
import type { Quality } from './drawn';

/** Makes the WebGL renderer of a drawing profile. */
export function rendererFor(canvas: HTMLCanvasElement, quality: Quality): WebGLRenderer {
  const full = quality === 'full';
  const context = canvas.getContext('webgl2', {
    alpha: false, // saves the browser from blending the canvas with the page behind it
    antialias: full,
    powerPreference: 'high-performance',
    preserveDrawingBuffer: true, // pictures that are not drawn again must stay
  });
  const renderer = new WebGLRenderer({ canvas, context: present(context, 'WebGL 2 for the pictures') });
  renderer.setPixelRatio(full ? Math.min(window.devicePixelRatio, 2) : 0.75);
  renderer.autoClear = false;
  renderer.toneMapping = full ? AgXToneMapping : NoToneMapping;
  renderer.shadowMap.enabled = full;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}
