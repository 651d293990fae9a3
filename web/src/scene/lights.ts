import {
  DirectionalLight,
  HemisphereLight,
  type Light as Lit,
  type Object3D,
  PointLight,
  type Scene,
  SpotLight,
} from 'three';
import type { Daylight } from './daylight';
import { isSpot, type Lamp, PENUMBRA } from './floodlights';

/** Half the side of the square around the bay in which shadows are cast [m]. */
const SHADOWED = 15;
/** Height of the sun's shadow camera [m]. */
const HEIGHT = 40;
/** Exponent of the decay of a lamp's light with distance. */
const DECAY = 1.8;

/**
 * The full profile's lights: sun, earthshine, skylight, and the lamps that bodies carry. A light that
 * is off stays in the scene with intensity 0: another number of lights needs other shaders, which take
 * seconds to compile.
 */
export class Lights {
  private readonly sun = shadowing();
  private readonly earthshine = new DirectionalLight();
  private readonly sky = new HemisphereLight();
  private readonly lamps: readonly { readonly lamp: Lamp; readonly lit: PointLight | SpotLight }[];
  private readonly added: Object3D[] = [];

  constructor(stage: Scene, lamps: readonly Lamp[]) {
    this.sky.position.set(0, 0, 1);
    for (const light of [this.sun, this.earthshine, this.sky]) this.add(stage, light);
    this.lamps = lamps.map((lamp) => ({ lamp, lit: this.addLamp(lamp) }));
  }

  /** Set the light of sun, Earth and sky, and the switches that are on. */
  set(daylight: Daylight, on: ReadonlySet<string>): void {
    const { sun, earthshine, sky } = this;
    sun.color.copy(daylight.sun);
    sun.position.copy(daylight.toSun).multiplyScalar(HEIGHT);
    earthshine.color.copy(daylight.earthshine);
    earthshine.position.copy(daylight.nadir).multiplyScalar(HEIGHT);
    sky.color.copy(daylight.above);
    sky.groundColor.copy(daylight.below);
    for (const light of [sun, earthshine, sky]) light.updateMatrixWorld();
    for (const { lamp, lit } of this.lamps)
      lit.intensity = on.has(lamp.light.switch) ? lamp.light.intensity : 0;
  }

  dispose(): void {
    for (const each of this.added) each.removeFromParent();
    for (const light of [this.sun, this.earthshine, this.sky]) light.dispose();
    for (const { lit } of this.lamps) lit.dispose();
  }

  private add(parent: Object3D, each: Lit | Object3D): void {
    parent.add(each);
    each.updateMatrixWorld();
    this.added.push(each);
  }

  private addLamp({ light, body, place, colour }: Lamp): PointLight | SpotLight {
    const { cone, reach, intensity } = light;
    if (!isSpot(light)) {
      const lamp = new PointLight(colour, intensity, reach, DECAY);
      lamp.position.setFromMatrixPosition(place);
      this.add(body.group, lamp);
      return lamp;
    }
    const lamp = new SpotLight(colour, intensity, reach, cone, PENUMBRA, DECAY);
    lamp.position.setFromMatrixPosition(place);
    lamp.target.position.set(1, 0, 0).applyMatrix4(place);
    this.add(body.group, lamp.target);
    this.add(body.group, lamp);
    return lamp;
  }
}

function shadowing(): DirectionalLight {
  const light = new DirectionalLight();
  light.castShadow = true;
  const { shadow } = light;
  shadow.mapSize.set(4096, 4096);
  shadow.camera.left = shadow.camera.bottom = -SHADOWED;
  shadow.camera.right = shadow.camera.top = SHADOWED;
  shadow.camera.near = 5;
  shadow.camera.far = 2 * HEIGHT;
  shadow.bias = -0.0006;
  shadow.normalBias = 0.02;
  shadow.radius = 2.5;
  return light;
}
