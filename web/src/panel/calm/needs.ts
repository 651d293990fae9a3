/**
 * The parts of the page that the operator needs, by name. An element with a `data-calm` attribute is shown on the calm
 * page only while its name is needed. A name is that of a desk group (`joints`), a function (`rate hold`), a mode
 * (`mode PL`) or a camera (`camera WR`); nothing needs the name `full`.
 */

import { ROWS } from '../../input/keymap';
import type { ModeInfo, StepInfo } from '../../link/protocol';
import { LAMPS, type LampName } from '../spine/lamps';

/** Groups with the displays and switches of functions. */
const GROUP_OF: ReadonlyMap<string, string> = new Map(
  ROWS.flatMap(({ group, uses }) => (group ? uses.map(({ name }) => [name, group] as const) : [])),
);

/** Parts of the rail that belong to a lamp. */
const IN_RAIL: Partial<Record<LampName, string>> = { 'LINK DELAY': 'delays', CONTROLLER: 'controllers' };

/** State of a run from which the needs beside those of the task follow. */
export interface Situation {
  /** The lamps with a caution or a warning. */
  readonly lamps: readonly LampName[];
  /** The entered mode and the selected mode. */
  readonly modes: readonly (ModeInfo | undefined)[];
  /** The cameras on the monitors. */
  readonly cameras: readonly string[];
  readonly holding: boolean;
  readonly orbiting: boolean;
}

/** Returns what a step needs: its groups, functions, mode and cameras, and what its texts quote from the desk. */
export function stepNeeds({ groups, uses, mode, cameras, text, hints }: StepInfo): readonly string[] {
  const all = [...uses, ...hints.flatMap((hint) => hint.uses)].map(({ use }) => use);
  const texts = [text, ...hints.map((hint) => hint.text)];
  return [
    ...groups,
    ...all.flatMap(useNeeds),
    ...(mode ? [`mode ${mode}`] : []),
    ...cameras.map((name) => `camera ${name}`),
    ...texts.flatMap(quoted),
  ];
}

/** Returns what a function needs: its own switch, and the group with its displays. */
export function useNeeds(use: string): readonly string[] {
  return [use, GROUP_OF.get(use) ?? use];
}

/** Returns what the state of the run needs. A lamp needs the group that shows its cause. */
export function situationNeeds({ lamps, modes, cameras, holding, orbiting }: Situation): readonly string[] {
  const kinds = modes.flatMap((mode) => mode?.kind ?? []);
  return [
    ...lamps.map((name) => LAMPS[name].group.slice(1)),
    ...(lamps.some((name) => name !== 'CHECK CRT' && LAMPS[name].row === 'arm') ? ['limits'] : []),
    ...lamps.flatMap((name) => IN_RAIL[name] ?? []),
    ...(kinds.includes('automatic') ? ['proceed'] : []),
    ...(kinds.includes('single') ? ['joints'] : []),
    ...modes.flatMap((mode) => (mode ? [`mode ${mode.position}`] : [])),
    ...cameras.map((name) => `camera ${name}`),
    ...(holding ? ['effector'] : []),
    ...(orbiting ? ['fly orbiter'] : []),
  ];
}

/** Returns the names that a text may quote: `*WR*` is a camera, `*END EFF*` a mode, `*LOOK AHEAD*` a group. */
function quoted(text: string): readonly string[] {
  return [...text.matchAll(/\*([^*]+)\*/g)].flatMap(([, name = '']) => [
    `camera ${name}`,
    `mode ${name}`,
    name.toLowerCase(),
  ]);
}
