/** Chooses the drawing profile according to the renderer. */

import type { Quality } from '../scene/drawn';

export interface Drawing {
  readonly quality: Quality;
  /** Renderer's name in WebGL. */
  readonly renderer: string;
  /** Whether the processor computes the pictures, because there is no graphics card. */
  readonly software: boolean;
}

/**
 * Returns the renderer and the drawing profile; null without WebGL 2. The profile is the one that `?quality=` names. By
 * default, it is full with a graphics card and low without one.
 */
export function chooseDrawing(search: string): Drawing | null {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return null;
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  const software = isSoftware(renderer);
  const asked = new URLSearchParams(search).get('quality');
  const quality = asked === 'low' || asked === 'full' ? asked : software ? 'low' : 'full';
  return { quality, renderer, software };
}

export function isSoftware(renderer: string): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
}
