import { vi } from 'vitest';
import type { Reading } from '../src/input/reading';

/** Readings of gamepads, and gamepads that a test connects and moves. */

export const NO_AXES = [0, 0, 0, 0];

export function reading(axes: readonly number[], pressed: Record<number, number> = {}): Reading {
  const buttons = Array.from({ length: 17 }, (_, i) => ({
    pressed: (pressed[i] ?? 0) > 0.5,
    touched: false,
    value: pressed[i] ?? 0,
  }));
  return { axes, buttons };
}

/** Replaces the browser's gamepads with gamepads that a test connects and moves. */
export function plugged(
  ...pads: { id: string; axes?: number[]; standard?: boolean; buttons?: Record<number, number> }[]
) {
  const there = pads.map((pad, index) => ({ ...pad, index }));
  const listed: (number | null)[] = there.map(({ index }) => index);
  vi.stubGlobal('navigator', {
    getGamepads: () =>
      listed.map((which) => {
        const pad = which === null ? undefined : there[which];
        if (!pad) return null;
        return {
          ...reading(pad.axes ?? NO_AXES, pad.buttons),
          connected: true,
          mapping: (pad.standard ?? true) ? 'standard' : '',
          id: pad.id,
          index: pad.index,
        };
      }),
  });
  return {
    axes(which: number, ...axes: number[]) {
      const pad = there[which];
      if (pad) pad.axes = axes;
    },
    unplug(which: number) {
      listed[which] = null;
    },
    plug(which: number) {
      listed[which] = which;
    },
  };
}
