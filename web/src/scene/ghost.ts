import {
  Color,
  EdgesGeometry,
  LinearSRGBColorSpace,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  Object3D,
  Quaternion,
  ShaderMaterial,
  type Scene as Stage,
  Vector3,
} from 'three';
import type { Body } from './bodies';

/** Opacity of faces seen from the front and of faces seen from the side. */
export interface Faces {
  readonly fill: number;
  readonly rim: number;
}

/** Opacity of edges. */
const EDGE = 0.5;
/** Time in which the ghost appears and disappears [s]. */
const FADE_S = 0.15;
/** Least angle between two faces at which an edge is drawn [deg]. */
const CORNER = 30;
/** A body that moves less than this has no ghost, because the ghost would flicker on the body [m, rad]. */
const STIRS = 0.02;
/** Number of values for each body in the look-ahead's poses. */
const POSE = 7;

const ONE = new Vector3(1, 1, 1);
const place = new Vector3();
const turn = new Quaternion();
const [from, facing, size] = [new Vector3(), new Quaternion(), new Vector3()];

const vertexShader = /* glsl */ `
  varying vec3 ray, n;
  void main() {
    vec4 at = viewMatrix * modelMatrix * vec4(position, 1.0);
    ray = at.xyz;
    n = mat3(viewMatrix) * mat3(modelMatrix) * normal;
    gl_Position = projectionMatrix * at;
  }`;

/**
 * Makes a face the more opaque, the more it is seen from the side. This shows the outline of a tube, because few of its
 * edges are drawn.
 */
const fragmentShader = /* glsl */ `
  varying vec3 ray, n;
  uniform vec3 colour;
  uniform float shown, fill, rim;
  void main() {
    float turned = 1.0 - abs(dot(normalize(ray), normalize(n)));
    gl_FragColor = vec4(colour, shown * mix(fill, rim, turned));
  }`;

/** Bodies at other poses than their own, as transparent shapes of one colour. */
export class Ghost {
  private readonly fill;
  private readonly edge;
  private readonly parts: readonly { readonly part: Object3D; readonly body: Body; moves: boolean }[];
  private readonly lines: LineSegments[] = [];
  private shown = 0;
  private at = performance.now();
  private hidden = false;

  /** `colour`: a colour `#rrggbb`, which is displayed as it is, neither lit nor converted. */
  constructor(stage: Stage, bodies: readonly Body[], colour: string, faces: Faces) {
    this.fill = new ShaderMaterial({
      uniforms: {
        colour: { value: new Color().setStyle(colour, LinearSRGBColorSpace) },
        shown: { value: 0 },
        fill: { value: faces.fill },
        rim: { value: faces.rim },
      },
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: 1,
    });
    this.edge = new LineBasicMaterial({
      color: colour,
      transparent: true,
      opacity: 0,
      depthWrite: false,
      toneMapped: false,
    });
    this.parts = bodies.map((body) => {
      const part = new Object3D();
      part.matrixAutoUpdate = false;
      for (const mesh of body.plain) this.add(part, mesh);
      stage.add(part);
      return { part, body, moves: false };
    });
    this.setVisible(false);
  }

  /** Present opacity: 0 is invisible. */
  get opacity(): number {
    return this.shown;
  }

  /**
   * Sets the poses: seven numbers for each body, as in `Display.poses`. Null lets the ghost fade with the time `now` [ms],
   * or hides it if `now` is null: the pictures drawn next show a frame without the ghost.
   */
  set(poses: readonly number[] | null, now: number | null): void {
    this.hidden = !poses && now === null;
    if (now !== null) this.fade(poses ? 1 : -1, now);
    if (!poses) return;
    this.parts.forEach((each, i) => {
      const { part, body } = each;
      const first = POSE * i;
      place.fromArray(poses, first);
      turn.set(poses[first + 4] ?? 0, poses[first + 5] ?? 0, poses[first + 6] ?? 0, poses[first + 3] ?? 1);
      body.group.matrixWorld.decompose(from, facing, size);
      each.moves = from.distanceTo(place) > STIRS || facing.angleTo(turn) > STIRS;
      part.matrix.compose(place, turn, ONE);
      part.updateMatrixWorld(true);
    });
  }

  /** Sets whether the pictures that are drawn next show the ghost. */
  setVisible(on: boolean): void {
    for (const { part, moves } of this.parts) part.visible = on && !this.hidden && moves && this.shown > 0;
  }

  dispose(): void {
    for (const { part } of this.parts) part.removeFromParent();
    for (const { geometry } of this.lines) geometry.dispose();
    this.fill.dispose();
    this.edge.dispose();
  }

  private fade(way: 1 | -1, now: number): void {
    const step = Math.max(0, now - this.at) / 1000 / FADE_S;
    this.at = now;
    this.shown = Math.min(1, Math.max(0, this.shown + way * step));
    const { shown } = this.fill.uniforms;
    if (shown) shown.value = this.shown;
    this.edge.opacity = EDGE * this.shown;
  }

  private add(part: Object3D, { geometry }: Mesh): void {
    const mesh = new Mesh(geometry, this.fill);
    mesh.renderOrder = 1;
    mesh.matrixAutoUpdate = false;
    part.add(mesh);
    const lines = new LineSegments(new EdgesGeometry(geometry, CORNER), this.edge);
    lines.renderOrder = 1;
    lines.matrixAutoUpdate = false;
    this.lines.push(lines);
    part.add(lines);
  }
}
