/** The lens of a camera: its field of view in a picture, of which other pictures may cover a part. */

import { MathUtils, PerspectiveCamera } from 'three';
import { ASPECT, type Part } from './drawn';
import { fieldOf, WHOLE } from './free-part';

export class Lens extends PerspectiveCamera {
  /** Horizontal field of view [rad]. */
  private wide = 1;
  private free = WHOLE;
  private fitted = '';

  constructor(near: number, far: number) {
    super(40, ASPECT, near, far);
  }

  /** Sets the horizontal field of view [rad]. */
  set angle(angle: number) {
    if (angle !== this.wide) this.fitted = '';
    this.wide = angle;
  }

  /**
   * Fits the field of view into a part of a picture with this aspect. It does not depend on the aspect, unless the part is
   * low: it then shows more at its sides, and nothing less above and below.
   */
  fit(aspect: number, free: Part): void {
    const { left, top, width, height } = free;
    const fitted = `${aspect} ${left} ${top} ${width} ${height}`;
    if (fitted === this.fitted) return;
    this.fitted = fitted;
    const field = fieldOf({ width: aspect * width, height });
    this.fov = MathUtils.radToDeg(2 * Math.atan(Math.tan(this.wide / 2) / field));
    this.aspect = aspect;
    this.free = free;
    this.updateProjectionMatrix();
  }

  override updateProjectionMatrix(): void {
    super.updateProjectionMatrix();
    const { left, top, width, height } = this.free ?? WHOLE; // the base class calls this function before it is set
    const { elements } = this.projectionMatrix;
    elements[8] = (elements[8] ?? 0) - (2 * left + width - 1);
    elements[9] = (elements[9] ?? 0) + (2 * top + height - 1);
    this.projectionMatrixInverse.copy(this.projectionMatrix).invert();
  }
}
