/** Finds the subjects of the work in the scene: the tip, the payload, the target, and the minimum clearance. */

import type { ClosestPoints, Frame, Vec3, Welcome } from '../link/protocol';
import type { Need, Places, Subject } from './best-pair';

/** Prefix of the names of the arm's bodies; name of the scenario's attached payload. */
export const [ARM, PAYLOAD] = ['arm.', 'payload'];

/** A subject's position, the body that it is (null for a point), and its diameter [m]. */
export interface Found {
  readonly place: Vec3;
  readonly body: string | null;
  readonly diameter: number;
}

/** What this module asks of the scene. */
export interface Bodies {
  middle(name: string): Vec3 | null;
  diameter(name: string): number;
}

/** Diameter of a keyed-in target [m]: about that of the end effector, which will be there. */
const POINT_M = 0.5;

export class Subjects {
  /** Name of the body that carries the tip. */
  readonly tip: string;
  private readonly payloads: readonly string[];
  private readonly stations: readonly string[];

  constructor(
    private readonly bodies: Bodies,
    welcome: Pick<Welcome, 'work' | 'bodies'>,
  ) {
    this.tip = welcome.work.effector[0] ?? '';
    const names = new Set([...welcome.work.cargo, PAYLOAD]);
    const [, ...others] = welcome.bodies.map(({ name }) => name);
    this.payloads = others.filter((name) => names.has(name));
    this.stations = others.filter((name) => !names.has(name) && !name.startsWith(ARM));
  }

  /** Returns all subjects at a frame, which the scene must already show; null for each one that does not exist. */
  at(frame: Frame, gap: ClosestPoints | null): Readonly<Record<Subject, Found | null>> {
    return {
      tip: this.body(this.tip),
      payload: this.first(this.payloads),
      target: this.target(frame),
      gap: gap && { place: gap.plane, body: null, diameter: Math.max(POINT_M, apart(gap)) },
    };
  }

  /**
   * Returns what a pair of pictures has to show at a frame: the hand, which is the tip or the payload that it holds;
   * and what the hand works on, which is the target or else the payload.
   */
  needs(frame: Frame): readonly Need[] {
    const { payload, target } = this.at(frame, null);
    const holds = this.holds(frame);
    const hand: Need = holds ? ['tip', 'payload'] : ['tip'];
    if (target) return [hand, ['target']];
    return payload && !holds ? [hand, ['payload']] : [hand];
  }

  /** Returns whether a body moves with the arm. */
  isCarried(body: string, frame: Frame): boolean {
    return body.startsWith(ARM) || (this.payloads.includes(body) && this.holds(frame));
  }

  /** Returns whether the arm holds a payload. The scenario's own payload is always held. */
  holds({ work }: Frame): boolean {
    return work.cargo.some(({ held }) => held) || (work.cargo.length === 0 && this.payloads.length > 0);
  }

  /**
   * Returns the target: the keyed-in target of an automatic mode, or else the body at which a held payload can be
   * docked. The empty end effector's target is the payload, which is a subject of its own.
   */
  private target(frame: Frame): Found | null {
    const { aim, actual } = frame.display;
    const held = frame.work.cargo.find(({ held }) => held);
    if (!aim) return held ? this.first(this.stations) : null;
    const from = this.bodies.middle(held?.name ?? this.tip);
    if (!from) return null;
    // The panel's X points forward and its Z down; the scene's x points aft and its z up.
    const [x, y, z] = aim.position.map((value, i) => value - (actual.position[i] ?? 0)) as [
      number,
      number,
      number,
    ];
    return { place: [from[0] - x, from[1] + y, from[2] - z], body: null, diameter: POINT_M };
  }

  private first(names: readonly string[]): Found | null {
    return names.map((name) => this.body(name)).find((found) => found !== null) ?? null;
  }

  private body(name: string): Found | null {
    const place = this.bodies.middle(name);
    return place && { place, body: name, diameter: this.bodies.diameter(name) };
  }
}

/** Returns the positions of subjects. */
export function placesOf(found: Readonly<Record<Subject, Found | null>>): Places {
  const { tip, payload, target, gap } = found;
  return {
    tip: tip?.place ?? null,
    payload: payload?.place ?? null,
    target: target?.place ?? null,
    gap: gap?.place ?? null,
  };
}

function apart({ point_a, point_b }: ClosestPoints): number {
  return Math.hypot(...point_a.map((value, i) => value - (point_b[i] ?? 0)));
}
