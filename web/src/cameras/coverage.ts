/** Survey of all cameras, one after the other: the targets that each sees, and the best cameras for the monitors. */

import type { Camera, ClosestPoints, Frame, Vec3, Welcome } from '../link/protocol';
import { stickToPicture } from '../panel/monitors/axes';
import type { Scene } from '../scene';
import { bestPair, type Pair, type Sighting, TARGETS, type Target } from './best-pair';

/** Prefix of the names of the arm's bodies; names of the body with the tip and of the scenario's attached payload. */
const [ARM, TIP, PAYLOAD] = ['arm.', 'arm.wrist_roll', 'payload'];

type Places = Readonly<Record<Target, Vec3 | null>>;

export class Survey {
  private readonly seen = new Map<string, Sighting>();
  private readonly payloads: readonly string[];
  private at: Places = { tip: null, payload: null, gap: null };
  private next = 0;

  constructor(
    private readonly scene: Scene,
    private readonly welcome: Pick<Welcome, 'cameras' | 'work' | 'bodies'>,
  ) {
    const names = new Set([...welcome.work.cargo, PAYLOAD]);
    this.payloads = welcome.bodies.map(({ name }) => name).filter((name) => names.has(name));
  }

  /** Surveys the next `count` cameras at a frame. The scene must already show this frame. */
  look(frame: Frame, gap: ClosestPoints | null, count: number): void {
    const { cameras } = this.welcome;
    this.at = {
      tip: this.place('tip', gap),
      payload: this.place('payload', gap),
      gap: this.place('gap', gap),
    };
    for (let i = 0; i < count; i += 1) {
      const camera = cameras[this.next % cameras.length];
      this.next += 1;
      if (camera) this.seen.set(camera.name, this.sighting(camera, frame, gap));
    }
  }

  /** Returns the position of a target in the scene; null if there is no such target. */
  place(target: Target, gap: ClosestPoints | null): Vec3 | null {
    if (target === 'tip') return this.scene.middle(TIP);
    if (target === 'gap') return gap?.plane ?? null;
    return this.payloads.map((name) => this.scene.middle(name)).find((place) => place !== null) ?? null;
  }

  /** Surveys all cameras. */
  lookAll(frame: Frame, gap: ClosestPoints | null): void {
    this.look(frame, gap, this.welcome.cameras.length);
  }

  /** Returns the targets that a camera saw in its last survey. */
  sees(camera: Camera): readonly Target[] {
    const seen = this.seen.get(camera.name)?.sees;
    return TARGETS.filter((target) => seen?.has(target));
  }

  /** Positions of all targets. */
  get places(): readonly Vec3[] {
    return Object.values(this.at).filter((place) => place !== null);
  }

  /** The best pair of television cameras. */
  best(): Pair | null {
    return this.bestOf(({ kind }) => kind === 'camera');
  }

  /**
   * Returns the initial cameras of the two monitors: the best pair that contains no camera on the arm, because the view
   * of such a camera changes when the arm moves. If the end effector is empty and the camera on it sees a payload,
   * the second monitor shows this camera.
   */
  first(frame: Frame): readonly Camera[] {
    const { cameras } = this.welcome;
    const pair = this.bestOf(({ kind, body }) => kind === 'camera' && !body.startsWith(ARM)) ?? this.best();
    const named = (pair?.cameras ?? []).flatMap(({ camera }) =>
      cameras.filter(({ name }) => name === camera),
    );
    const held = frame.work.cargo.some((cargo) => cargo.held);
    const own = cameras.find(({ body, kind }) => body === TIP && kind === 'camera');
    const aimed = !held && own && this.sees(own).includes('payload') ? [own] : [];
    return [...named.slice(0, 2 - aimed.length), ...aimed, ...cameras].slice(0, 2);
  }

  private bestOf(allowed: (camera: Camera) => boolean): Pair | null {
    const sightings = this.welcome.cameras
      .filter(allowed)
      .map(({ name }) => this.seen.get(name))
      .filter((sighting) => sighting !== undefined);
    return bestPair(sightings, this.at);
  }

  private sighting(camera: Camera, frame: Frame, gap: ClosestPoints | null): Sighting {
    const { sight } = this.scene;
    const sees = new Set<Target>();
    const ahead = sight.ahead(camera);
    if (ahead.has(TIP) || sight.body(camera, TIP)) sees.add('tip');
    if (this.payloads.some((name) => ahead.has(name) || sight.body(camera, name))) sees.add('payload');
    if (gap && sight.line(camera, gap.point_a, gap.point_b)) sees.add('gap');
    const turned = stickToPicture(this.scene.cameras.directions(camera.name, frame.display.axes));
    return { camera: camera.name, sees, lens: sight.lens(camera), turned };
  }
}

/** Returns a description of the best pair, in a few sentences. */
export function pairWords(pair: Pair | null): readonly string[] {
  if (!pair) return ['No two cameras see the same target.'];
  const [a, b] = pair.cameras;
  const angle = (radians: number) => `${Math.round((radians * 180) / Math.PI)}°`;
  return [
    `${a.camera} and ${b.camera} both see the ${pair.targets.join(' and the ')}, ${angle(pair.apart)} apart.`,
    `Angle between stick axes and picture: ${a.camera} ${angle(a.turned)}, ${b.camera} ${angle(b.turned)}.`,
  ];
}
