/** Survey of all cameras, one after the other: the subjects that each shows, and the best cameras for the monitors. */

import type { Camera, ClosestPoints, Frame, Vec3, Welcome } from '../link/protocol';
import { stickToPicture } from '../panel/monitors/axes';
import type { Scene } from '../scene';
import {
  bestPair,
  CROSSED,
  clarity,
  type Need,
  type Pair,
  type Sighting,
  SUBJECTS,
  type Subject,
  score,
  suffices,
} from './best-pair';
import { orbitsAround } from './free-view';
import { type Found, placesOf, Subjects } from './subjects';

/** Distance of the point that stands for the sun [m]. */
const FAR_M = 300;

/** Factor for the part of a picture that a near body fills: such a picture shows a wall, not the body. */
const NEAR = 0.3;

type Seen = Readonly<Record<Subject, Found | null>>;

export class Survey {
  private readonly seen = new Map<string, Sighting>();
  private readonly subjects: Subjects;
  /** Modes in which a stick drives one joint: the sticks then have no direction in a picture. */
  private readonly oneJoint: ReadonlySet<string>;
  private found: Seen = { tip: null, payload: null, target: null, gap: null };
  private needs: readonly Need[] = [];
  private next = 0;

  constructor(
    private readonly scene: Scene,
    private readonly welcome: Pick<Welcome, 'cameras' | 'work' | 'bodies' | 'modes'>,
  ) {
    this.subjects = new Subjects(scene, welcome);
    const single = welcome.modes.filter(({ kind }) => kind === 'single');
    this.oneJoint = new Set(single.map(({ position }) => position));
  }

  /** Surveys the next `count` cameras at a frame. The scene must already show this frame. */
  look(frame: Frame, gap: ClosestPoints | null, count: number): void {
    const { cameras } = this.welcome;
    this.found = this.subjects.at(frame, gap);
    this.needs = this.subjects.needs(frame);
    for (let i = 0; i < count; i += 1) {
      const camera = cameras[this.next % cameras.length];
      this.next += 1;
      if (camera) this.seen.set(camera.name, this.sighting(camera, frame, gap));
    }
  }

  /** Returns whether the sticks drive one joint. */
  drivesOneJoint({ mode }: Frame): boolean {
    return this.oneJoint.has(mode);
  }

  /** Surveys all cameras. */
  lookAll(frame: Frame, gap: ClosestPoints | null): void {
    this.look(frame, gap, this.welcome.cameras.length);
  }

  /** Returns the position of a subject in the scene; null if there is no such subject. */
  place(subject: Subject, frame: Frame, gap: ClosestPoints | null): Vec3 | null {
    return this.subjects.at(frame, gap)[subject]?.place ?? null;
  }

  /** Returns the last survey of a camera. */
  of(camera: Camera): Sighting | null {
    return this.seen.get(camera.name) ?? null;
  }

  /** Returns the subjects that a camera showed in its last survey. */
  sees(camera: Camera): readonly Subject[] {
    const shows = this.seen.get(camera.name)?.shows;
    return SUBJECTS.filter((subject) => (shows?.[subject] ?? 0) > 0);
  }

  /** Positions of all subjects. */
  get places(): readonly Vec3[] {
    return Object.values(placesOf(this.found)).filter((place) => place !== null);
  }

  /** Returns the best pair of the last surveys. */
  best(): Pair | null {
    return bestPair([...this.seen.values()], placesOf(this.found), this.needs);
  }

  /** Surveys all cameras. If no pair suffices, first directs the engineering view so that it helps. */
  open(frame: Frame, gap: ClosestPoints | null): void {
    this.lookAll(frame, gap);
    const best = this.best();
    const free = this.welcome.cameras.find(({ kind }) => kind === 'engineering');
    if (!free || (best && suffices(best, this.needs))) return;
    const places = placesOf(this.found);
    const orbits = orbitsAround(this.centred(), free.field_of_view);
    const seen = orbits.map((orbit) => {
      this.scene.cameras.place(free.name, orbit);
      return [orbit, this.sighting(free, frame, gap)] as const;
    });
    const [chosen] = seen
      .filter(([, sighting]) => sighting.turned <= CROSSED)
      .sort(([, a], [, b]) => score(b, b, places) - score(a, a, places));
    if (!chosen) return;
    const [orbit, sighting] = chosen;
    this.scene.cameras.place(free.name, orbit);
    this.seen.set(free.name, sighting);
  }

  /** Returns the subjects around which the engineering view is directed. */
  private centred(): readonly Found[] {
    const { tip, payload, target } = this.found;
    return [tip, payload, target].filter((found) => found !== null);
  }

  /**
   * Returns the initial cameras of the two monitors: the best pair. If the end effector is empty and the camera on it
   * shows a payload, the second monitor shows this camera.
   */
  first(frame: Frame): readonly Camera[] {
    const { cameras } = this.welcome;
    const named = (this.best()?.cameras ?? []).flatMap(({ camera }) =>
      cameras.filter(({ name }) => name === camera),
    );
    const own = cameras.find(({ body, kind }) => body === this.subjects.tip && kind === 'camera');
    const aimed = !this.subjects.holds(frame) && own && this.isAimed(own) ? [own] : [];
    return [
      ...named.filter((camera) => !aimed.includes(camera)).slice(0, 2 - aimed.length),
      ...aimed,
      ...cameras,
    ]
      .filter((camera, i, all) => all.indexOf(camera) === i)
      .slice(0, 2);
  }

  private isAimed(camera: Camera): boolean {
    const sighting = this.seen.get(camera.name);
    return sighting !== undefined && sighting.shows.payload > 0 && sighting.turned <= CROSSED;
  }

  private sighting(camera: Camera, frame: Frame, gap: ClosestPoints | null): Sighting {
    const { sight, lit, cameras } = this.scene;
    const lens = sight.lens(camera);
    const ahead = sight.ahead(camera);
    const glare = this.glares(camera, lens);
    const clear = (subject: Subject): number => {
      const found = this.found[subject];
      if (!found) return 0;
      const visible = this.visible(camera, found, subject === 'gap' ? gap : null, ahead);
      if (visible === 0) return 0;
      const away = Math.hypot(...lens.map((value, i) => value - (found.place[i] ?? 0)));
      const size = found.diameter / Math.max(sight.width(camera, away), 1e-3);
      return clarity({ visible, size, light: lit.seen(found.place, lens), glare });
    };
    return {
      camera: camera.name,
      kind: camera.kind,
      onArm: this.subjects.isCarried(camera.body, frame),
      shows: { tip: clear('tip'), payload: clear('payload'), target: clear('target'), gap: clear('gap') },
      lens,
      turned: this.drivesOneJoint(frame)
        ? 0
        : stickToPicture(cameras.directions(camera.name, frame.display.axes)),
    };
  }

  /** Returns the fraction of a subject that a camera sees; `ahead`: bodies at sample points of the picture. */
  private visible(
    camera: Camera,
    { body, place }: Found,
    gap: ClosestPoints | null,
    ahead: ReadonlyMap<string, number>,
  ): number {
    const { sight } = this.scene;
    if (gap) return sight.line(camera, gap.point_a, gap.point_b) ? 1 : 0;
    if (body === null) return sight.point(camera, place) ? 1 : 0;
    return Math.max(sight.visible(camera, body), NEAR * (ahead.get(body) ?? 0));
  }

  /** Returns whether the sun is in a camera's picture and not hidden. */
  private glares(camera: Camera, lens: Vec3): boolean {
    const { sun } = this.scene.lit;
    if (!sun) return false;
    const far = lens.map((value, i) => value + FAR_M * (sun[i] ?? 0)) as unknown as Vec3;
    return this.scene.sight.point(camera, far);
  }
}

/** Returns a description of the best pair, in a few sentences. */
export function pairWords(pair: Pair | null): readonly string[] {
  if (!pair) return ['No two cameras show the tip, the payload, the target or the minimum clearance.'];
  const [a, b] = pair.cameras;
  const angle = (radians: number) => `${Math.round((radians * 180) / Math.PI)}°`;
  const apart =
    pair.apart === null
      ? `${a.camera} and ${b.camera} show different subjects.`
      : `${a.camera} and ${b.camera} both see ${pair.both.join(', ')}, ${angle(pair.apart)} apart.`;
  return [
    apart,
    `Angle between stick axes and picture: ${a.camera} ${angle(a.turned)}, ${b.camera} ${angle(b.turned)}.`,
  ];
}
