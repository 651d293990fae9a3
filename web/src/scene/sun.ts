import { CircleGeometry, Mesh, MeshBasicMaterial, type Scene, Vector3 } from 'three';
import type { Daylight } from './daylight';
import { LIMB } from './earth';

/** Half the sun's angular diameter: 16 minutes of arc. */
const RADIUS = (16 / 60) * (Math.PI / 180);
/** Distance at which the sun is drawn, behind everything else [m]. */
const DISTANCE = 150;
const FORWARD = new Vector3(0, 0, 1);

/** The sun's disc on the sky, in the same direction for every camera. */
export class Sun {
  readonly disc: Mesh<CircleGeometry, MeshBasicMaterial>;
  private readonly toSun = new Vector3();
  private readonly eye = new Vector3();

  constructor(stage: Scene) {
    const material = new MeshBasicMaterial({ toneMapped: false });
    this.disc = new Mesh(new CircleGeometry(DISTANCE * Math.tan(RADIUS), 24), material);
    this.disc.name = 'sun';
    this.disc.frustumCulled = false;
    this.disc.onBeforeRender = (_renderer, _scene, camera) => {
      this.eye.setFromMatrixPosition(camera.matrixWorld);
      this.disc.position.copy(this.eye).addScaledVector(this.toSun, DISTANCE);
      this.disc.updateMatrixWorld();
    };
    stage.add(this.disc);
  }

  /** Sets the direction of the sun; hides the sun if it is behind the Earth. */
  set({ toSun, nadir }: Daylight): void {
    this.toSun.copy(toSun);
    this.disc.quaternion.setFromUnitVectors(FORWARD, this.eye.copy(toSun).negate());
    this.disc.visible = toSun.angleTo(nadir) > LIMB;
  }

  dispose(): void {
    this.disc.removeFromParent();
    this.disc.geometry.dispose();
    this.disc.material.dispose();
  }
}
