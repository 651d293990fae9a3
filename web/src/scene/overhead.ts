import { OrthographicCamera } from 'three';

/** Height from which the plan is drawn [m]. */
const HEIGHT = 150;

/** Part of the scene that the plan shows [m]. x, y: its lower left corner; x is aft (right), y starboard (up). */
export interface Extent {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The camera that looks straight down on the scene. */
export class Overhead {
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 1, 2 * HEIGHT);

  /** Returns the camera above an extent; the extent fills its picture. */
  over({ x, y, width, height }: Extent): OrthographicCamera {
    const { camera } = this;
    camera.position.set(x + width / 2, y + height / 2, HEIGHT);
    camera.up.set(0, 1, 0);
    camera.lookAt(camera.position.x, camera.position.y, 0);
    [camera.left, camera.right, camera.top, camera.bottom] = [-width / 2, width / 2, height / 2, -height / 2];
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }
}
