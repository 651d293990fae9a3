import {
  type Box3,
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  ShaderMaterial,
  type Scene as Stage,
  Vector2,
  Vector3,
} from 'three';
import type { ClosestPoints } from '../link/protocol';
import type { Body } from './bodies';

/** Widths of the line and of its dark edge [CSS px]. */
const WIDTH = 2;
const EDGE = 1.5;
/** A body within this distance of a closest point counts as the body of this point [m]. */
const NEAR = 0.3;
/** Least and greatest side length of the separating plane [m]. */
const LEAST = 0.6;
const GREATEST = 6;

const UP = new Vector3(0, 0, 1);
const FORE = new Vector3(1, 0, 0);
const point = new Vector3();
const size = new Vector3();

/** Widens the line on the screen. If one end is behind the camera, cuts the line just in front of the camera. */
const vertexShader = /* glsl */ `
  uniform vec3 a, b;
  uniform vec2 viewport;
  uniform float halfWidth;
  varying float side;
  void main() {
    vec4 p = modelViewMatrix * vec4(a, 1.0), q = modelViewMatrix * vec4(b, 1.0);
    const float nearest = -0.09;
    if (p.z > nearest) p = mix(q, p, (nearest - q.z) / (p.z - q.z));
    if (q.z > nearest) q = mix(p, q, (nearest - p.z) / (q.z - p.z));
    vec4 start = projectionMatrix * p, end = projectionMatrix * q;
    vec2 along = (end.xy / end.w - start.xy / start.w) * viewport;
    vec2 way = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    gl_Position = position.x < 0.5 ? start : end;
    gl_Position.xy += position.y * vec2(-way.y, way.x) * halfWidth * 2.0 / viewport * gl_Position.w;
    gl_Position.z -= 2e-5 * gl_Position.w;
    side = position.y;
  }`;

const fragmentShader = /* glsl */ `
  uniform vec3 colour;
  uniform float core;
  varying float side;
  void main() {
    gl_FragColor = vec4(abs(side) < core ? colour : vec3(0.0), 1.0);
  }`;

/** The line of minimum clearance, drawn where no body hides it, and on demand the separating plane. */
export class Gap {
  private readonly line = new Mesh(quad(), strokeMaterial());
  private readonly plane = new Object3D();
  private readonly fill = new MeshBasicMaterial({
    color: '#d9dbdc',
    transparent: true,
    opacity: 0.16,
    side: DoubleSide,
    depthWrite: false,
    toneMapped: false,
  });
  private readonly rim = new LineBasicMaterial({
    color: '#ffffff',
    transparent: true,
    opacity: 0.7,
    toneMapped: false,
  });
  private readonly square = square();
  private readonly boxes: readonly Box3[];

  constructor(
    stage: Stage,
    private readonly bodies: readonly Body[],
  ) {
    this.boxes = bodies.map((body) => body.box());
    this.line.frustumCulled = false;
    this.line.renderOrder = 2;
    this.plane.add(new Mesh(this.square, this.fill), new LineLoop(this.square, this.rim));
    for (const part of this.plane.children) part.renderOrder = 1;
    stage.add(this.line, this.plane);
    this.set(null, '#ffffff', false);
  }

  /** Draws the minimum clearance in a colour; null hides it. `plane`: whether the separating plane is drawn, too. */
  set(gap: ClosestPoints | null, colour: string, plane: boolean): void {
    this.line.visible = gap !== null;
    this.plane.visible = plane && gap !== null && Math.hypot(...gap.normal) > 0;
    if (!gap) return;
    const { uniforms } = this.line.material;
    uniforms['a']?.value.set(...gap.point_a);
    uniforms['b']?.value.set(...gap.point_b);
    uniforms['colour']?.value.set(...rgb(colour));
    if (this.plane.visible) this.turn(gap);
  }

  /** Prepares for a picture of this size [CSS px]. */
  fit(width: number, height: number): void {
    this.line.material.uniforms['viewport']?.value.set(width, height);
  }

  dispose(): void {
    this.line.geometry.dispose();
    this.line.material.dispose();
    this.square.dispose();
    this.fill.dispose();
    this.rim.dispose();
    this.line.removeFromParent();
    this.plane.removeFromParent();
  }

  /** Places the square of the separating plane halfway between the two bodies, as large as the smaller body. */
  private turn(gap: ClosestPoints): void {
    const { plane } = this;
    const normal = new Vector3(...gap.normal);
    plane.position.set(...gap.plane);
    plane.up.copy(Math.abs(normal.dot(UP)) > 0.9 ? FORE : UP);
    plane.lookAt(normal.add(plane.position));
    const side = Math.min(this.sizeAt(gap.point_a), this.sizeAt(gap.point_b));
    plane.scale.setScalar(Math.min(GREATEST, Math.max(LEAST, side)));
    plane.updateMatrixWorld(true);
  }

  /** Returns the greatest dimension of the smallest body at a point of the scene [m]. */
  private sizeAt(at: ClosestPoints['point_a']): number {
    let least = Number.POSITIVE_INFINITY;
    this.bodies.forEach(({ group }, i) => {
      const box = this.boxes[i];
      if (!box || box.isEmpty()) return;
      point.set(...at);
      if (box.distanceToPoint(group.worldToLocal(point)) > NEAR) return;
      least = Math.min(least, Math.max(...box.getSize(size).toArray()));
    });
    return least;
  }
}

/** Makes the line's quad: x is 0 or 1 for the line's ends, y is −1 or 1 for its sides. */
function quad(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

/** Makes a square with side 1, normal to z. */
function square(): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = [-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0];
  geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

function strokeMaterial(): ShaderMaterial {
  const half = WIDTH / 2 + EDGE;
  return new ShaderMaterial({
    uniforms: {
      a: { value: new Vector3() },
      b: { value: new Vector3() },
      viewport: { value: new Vector2(1, 1) },
      colour: { value: new Vector3() },
      halfWidth: { value: half },
      core: { value: WIDTH / 2 / half },
    },
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    depthWrite: false,
    transparent: true,
  });
}

/** Returns the three values of a colour `#rrggbb`, 0 to 1, as displayed. */
function rgb(colour: string): [number, number, number] {
  const part = (from: number) => Number.parseInt(colour.slice(from, from + 2), 16) / 255;
  return [part(1), part(3), part(5)];
}
