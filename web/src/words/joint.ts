/** Coordinates and rates of joints as texts. A joint that turns has angles; one that slides has lengths. */

import type { JointInfo } from '../link/protocol';
import { degrees, fixed, lengthText } from './format';
import type { Unit, Units } from './units';
import { spoken } from './way-out';

type Kind = Pick<JointInfo, 'slides'>;

const DEGREE = Math.PI / 180;
const ANGLE: Unit = { name: '°', perSi: 1 / DEGREE, decimals: 1 };
const TURN_RATE: Unit = { name: '°/s', perSi: 1 / DEGREE, decimals: 2 };
/** Names of units as a screen reader says them. */
const SAID: Readonly<Record<string, string>> = { '°': 'degrees', m: 'metres', in: 'inches' };

/** Returns the unit of a joint's coordinate: of its limits, and of its entries in a frame's `angles`. */
export function coordinateUnit({ slides }: Kind, { length }: Pick<Units, 'length'>): Unit {
  return slides ? length : ANGLE;
}

/** Returns the unit of a joint's rate and of its rate limits. */
export function rateUnit({ slides }: Kind, { speed }: Pick<Units, 'speed'>): Unit {
  return slides ? speed : TURN_RATE;
}

/** A coordinate with its sign and without its unit: `+12.3`, `−0.500`. */
export function coordinateText(joint: Kind, value: number, units: Units): string {
  const { perSi, decimals } = coordinateUnit(joint, units);
  return fixed(value * perSi, decimals);
}

/** A rate limit without its unit. */
export function rateText(joint: Kind, value: number, units: Units): string {
  const { perSi, decimals } = rateUnit(joint, units);
  return fixed(value * perSi, decimals, false);
}

/** The size of a motion of a joint, with its unit: `11.5°`, `42 cm`; `decimals`: those of an angle. */
export function motionText({ slides }: Kind, value: number, units: Units, decimals = 1): string {
  const size = Math.abs(value);
  return slides ? lengthText(size, units) : `${degrees(size, decimals, false)}°`;
}

/** The three ranges of a joint: `Elbow: reach −156.0° to +16.0°, soft …`. */
export function rangeText(joint: JointInfo, units: Units): string {
  const { name } = coordinateUnit(joint, units);
  const after = joint.slides ? ` ${name}` : name;
  const pair = ([low, high]: readonly [number, number]) =>
    `${coordinateText(joint, low, units)}${after} to ${coordinateText(joint, high, units)}${after}`;
  return `${joint.label}: reach ${pair(joint.reach)}, soft ${pair(joint.soft)}, hard ${pair(joint.hard)}`;
}

/** A coordinate as a number in its unit, for the attributes of a slider. */
export function coordinateNumber(joint: Kind, value: number, units: Units): string {
  const { perSi, decimals } = coordinateUnit(joint, units);
  return String(Number((value * perSi).toFixed(decimals)));
}

/** The commanded and the actual coordinate as a screen reader says them. */
export function coordinatesSaid(joint: Kind, commanded: number, actual: number, units: Units): string {
  const { name } = coordinateUnit(joint, units);
  const [goal, at] = [coordinateText(joint, commanded, units), coordinateText(joint, actual, units)];
  return `${goal} ${SAID[name] ?? name}, joint at ${at}`;
}

/** Steps by which keys move a joint of the master arm, small and large [rad or m]. */
export function keySteps({ slides }: Kind): readonly [small: number, large: number] {
  return slides ? [0.01, 0.1] : [0.5 * DEGREE, 5 * DEGREE];
}

/** Returns the joint with this name, as the station writes it in texts: `wrist roll`. */
export function jointCalled<Joint extends Pick<JointInfo, 'name'>>(
  name: string,
  joints: readonly Joint[],
): Joint | undefined {
  return joints.find((joint) => spoken(joint.name) === name);
}
