import type { Block, Frame, Moment } from '../src/link/protocol';
import { Player } from '../src/replay/player';

/** A player of a made-up recording. */

export const EXTENT = { period_s: 0.02, ticks: 1000, stride: 1, block: 100 };

/**
 * Makes a player of a recording whose blocks arrive without delay. `requested` lists the numbers of the requested
 * blocks.
 */
export async function player(extent: Partial<typeof EXTENT> = {}) {
  const all = { ...EXTENT, ...extent };
  const requested: number[] = [];
  const load = async (number: number): Promise<Block> => {
    requested.push(number);
    return Array.from({ length: all.block }, (_, i) => {
      const tick = 1 + (number * all.block + i) * all.stride;
      return { frame: { tick } as Frame, values: [], worst: '' } satisfies Moment;
    });
  };
  const made = new Player(all, load);
  await settled();
  return { player: made, requested };
}

export const settled = () => new Promise((resolve) => setTimeout(resolve));

/** Advances by `dt` in steps of 10 ms; waits for blocks after each step. */
export async function run(made: Player, dt: number) {
  for (let i = 0; i < dt / 0.01; i += 1) {
    made.advance(0.01);
    await Promise.resolve();
    await Promise.resolve();
  }
}
