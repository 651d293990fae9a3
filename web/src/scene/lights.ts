import {
  Color,
  DirectionalLight,
  HemisphereLight,
  type Light as Lit,
  type Object3D,
  PointLight,
  type Scene,
  SpotLight,
  Vector3,
} from 'three';
import type { Body, PlacedLight } from './bodies';

/** Direction to the sun: from aft, starboard and above, so that shadows fall forward into the bay. */
export const TO_SUN = new Vector3(0.46, 0.42, 0.72).normalize();
/** Direction to the Earth's centre. */
export const NADIR = new Vector3(-0.36, -0.62, -0.48).normalize();

/** Colours times intensity; the sun's gives the scale in which a file's lamps count. */
export const SUN = new Color('#fff6e8').multiplyScalar(4.1);
export const EARTHSHINE = new Color('#a9c6ee').multiplyScalar(0.55);
/** From the half sphere above the orbiter and from the one below it. */
export const SKYLIGHT = {
  above: new Color('#8fa3bf').multiplyScalar(0.32),
  below: new Color('#3a3632').multiplyScalar(0.32),
};

/** Half the side of the square round the bay that casts shadows [m]. */
const SHADOWED = 15;
/** How far up the sun's shadow camera stands [m]. */
const HEIGHT = 40;

/** The full profile's lights: sun, earthshine, skylight, and the lamps that bodies carry. */
export class Lights {
  private readonly lights: Lit[] = [];
  private readonly targets: Object3D[] = [];

  constructor(scene: Scene, bodies: readonly Body[]) {
    this.add(scene, sun());
    const earthshine = new DirectionalLight(EARTHSHINE);
    earthshine.position.copy(NADIR).multiplyScalar(HEIGHT);
    this.add(scene, earthshine);
    const sky = new HemisphereLight(SKYLIGHT.above, SKYLIGHT.below);
    sky.position.set(0, 0, 1);
    this.add(scene, sky);
    for (const body of bodies) for (const light of body.lights) this.addLamp(body, light);
  }

  dispose(): void {
    for (const light of [...this.lights, ...this.targets]) light.removeFromParent();
    for (const light of this.lights) light.dispose();
  }

  private add(parent: Object3D, light: Lit): void {
    parent.add(light);
    light.updateMatrixWorld();
    this.lights.push(light);
  }

  private addLamp(body: Body, { light, place }: PlacedLight): void {
    const { cone, reach, intensity } = light;
    if (cone > Math.PI / 2) {
      const lamp = new PointLight('#ffe9c9', intensity, reach, 1.8);
      lamp.position.setFromMatrixPosition(place);
      this.add(body.group, lamp);
      return;
    }
    const lamp = new SpotLight('#fff2dc', intensity, reach, cone, 0.7, 1.8);
    lamp.position.setFromMatrixPosition(place);
    lamp.target.position.set(1, 0, 0).applyMatrix4(place);
    body.group.add(lamp.target);
    this.targets.push(lamp.target);
    this.add(body.group, lamp);
  }
}

function sun(): DirectionalLight {
  const light = new DirectionalLight(SUN);
  light.position.copy(TO_SUN).multiplyScalar(HEIGHT);
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
