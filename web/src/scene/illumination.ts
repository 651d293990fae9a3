import {
  Mesh,
  MeshBasicMaterial,
  PMREMGenerator,
  SphereGeometry,
  Scene as Stage,
  type Texture,
  type WebGLRenderer,
} from 'three';
import type { LightCondition } from '../link/protocol';
import { Blob } from './blob';
import type { Body } from './bodies';
import { type Daylight, daylightOf, FULL_SUN } from './daylight';
import type { Quality } from './drawn';
import { Earth } from './earth';
import { lampsOf } from './floodlights';
import type { LambertLight } from './lambert';
import { Lights } from './lights';
import { Lit } from './lit';
import type { Materials } from './materials';
import { rodOf } from './rod';
import { Sun } from './sun';

/** Factor by which light is multiplied at an exposure of 0 stops. */
const EXPOSED = 1.1;

/** Sun, Earth and lamps, with the shadow and the reflections that they cause. */
export class Illumination {
  private readonly lights: Lights | null;
  private readonly earth: Earth;
  private readonly sun: Sun;
  private readonly blob: Blob | null;
  private reflections: Texture | null = null;
  private daylight: Daylight | null = null;
  private setting = '';
  /** Computes the light on a point of the scene. */
  readonly lit: Lit;

  /**
   * The first body of `bodies` is fixed, all others move. The shadow of the body `tip` falls on payloads: operators judge
   * by it how near the end effector is.
   */
  constructor(
    private readonly stage: Stage,
    private readonly renderer: WebGLRenderer,
    private readonly quality: Quality,
    bodies: readonly Body[],
    tip: string,
    private readonly materials: Materials,
    private readonly lambert: LambertLight,
    private readonly conditions: readonly LightCondition[],
  ) {
    const lamps = lampsOf(bodies);
    lambert.take(lamps);
    this.lit = new Lit(lamps);
    this.lights = quality === 'full' ? new Lights(stage, lamps) : null;
    this.earth = new Earth(stage, renderer, quality, lambert.exposure);
    this.sun = new Sun(stage);
    stage.environmentIntensity = 0.4;
    const [fixed, ...moving] = bodies;
    fixed?.drawLast();
    lambert.cast(bodies.filter(({ group }) => group.name === tip).flatMap(rodOf)[0] ?? null);
    const ground = quality === 'low' ? fixed?.mesh('liner') : undefined;
    this.blob = ground ? new Blob(stage, ground, moving) : null;
  }

  /** Exposure when the light condition begins [photographic stops above the exposure for full sunlight]. */
  get stops(): number {
    return this.daylight?.exposure ?? 0;
  }

  /** Sets the light condition and the lamps that are on; returns whether the condition has changed. */
  set(condition: string, lamps: readonly string[]): boolean {
    const setting = [condition, ...lamps].join();
    if (setting === this.setting) return false;
    this.setting = setting;
    const { daylight: before } = this;
    const daylight = before?.name === condition ? before : daylightOf(this.conditions, condition);
    this.daylight = daylight;
    const on = new Set(lamps);
    this.materials.lightUp(on);
    this.lambert.set(daylight, on);
    this.lit.set(daylight, on);
    this.lights?.set(daylight, on);
    if (daylight === before) return false;
    this.earth.set(daylight);
    this.sun.set(daylight);
    this.blob?.set(daylight);
    if (this.quality === 'full') {
      this.reflections?.dispose();
      this.reflections = reflections(this.renderer, this.earth, daylight);
      this.stage.environment = this.reflections;
    }
    return true;
  }

  /** Moves the lamps and the shadow with their bodies. */
  follow(): void {
    this.blob?.update();
    this.lambert.follow();
  }

  /** Sets the exposure of the next pictures [stops over full sunlight]; returns the factor that multiplies light. */
  expose(stops: number): number {
    const factor = EXPOSED * 2 ** stops;
    this.renderer.toneMappingExposure = factor;
    this.lambert.exposure.value = factor;
    return factor;
  }

  showEarth(on: boolean): void {
    this.earth.mesh.visible = on;
  }

  dispose(): void {
    this.blob?.dispose();
    this.reflections?.dispose();
    this.earth.dispose();
    this.sun.dispose();
    this.lights?.dispose();
  }
}

/** Makes the texture of Earth and sun that shiny surfaces reflect. */
function reflections(renderer: WebGLRenderer, earth: Earth, { toSun, sun: light }: Daylight): Texture {
  const stage = new Stage();
  const sphere = new SphereGeometry(3, 16, 12);
  const glare = new MeshBasicMaterial({ color: light.clone().multiplyScalar(30 / FULL_SUN) });
  const sun = new Mesh(sphere, glare);
  sun.position.copy(toSun).multiplyScalar(60);
  stage.add(sun, new Mesh(earth.mesh.geometry, earth.mesh.material));
  const generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromScene(stage, 0.02, 0.1, 200);
  generator.dispose();
  sphere.dispose();
  glare.dispose();
  return texture;
}
