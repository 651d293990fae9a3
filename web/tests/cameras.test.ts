import { Matrix4 } from 'three';
import { expect, test } from 'vitest';
import { bestPair, between, type Sighting, type Target } from '../src/cameras/best-pair';
import { CameraDrag } from '../src/input/camera-drag';
import { CameraHand, together, turningOf } from '../src/input/camera-hand';
import { DEFAULTS } from '../src/input/defaults';
import type { BodyInfo, Camera, Shape, Vec3 } from '../src/link/protocol';
import { Body } from '../src/scene/bodies';
import { Cameras } from '../src/scene/cameras';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';
import { Orbit } from '../src/scene/orbit';
import { Sight } from '../src/scene/sight';
import { settingOf, viewOf } from '../src/scene/view';
import { tornHere } from '../src/windows/opened';
import { lensWords, zoomed } from '../src/words/lens';
import views from './views.json';

interface Witness {
  readonly camera: Camera;
  readonly setting: Vec3;
  readonly position: Vec3;
  readonly boresight: Vec3;
  readonly up: Vec3;
}

const witnesses = views as unknown as readonly Witness[];
const degree = Math.PI / 180;
const still = { pan: 0, tilt: 0, zoom: 0 };

function near(a: readonly number[], b: readonly number[]): void {
  a.forEach((value, i) => {
    expect(value).toBeCloseTo(b[i] ?? Number.NaN, 7);
  });
}

test('a setting gives the view that it gives in the simulation', () => {
  expect(witnesses.length).toBeGreaterThan(10);
  for (const { camera, setting, position, boresight, up } of witnesses) {
    const view = viewOf(camera, setting);
    near(view.position, position);
    near(view.boresight, boresight);
    near(view.up, up);
    expect(view.angle).toBe(setting[2]);
  }
});

test('the setting at the start gives the view at the start', () => {
  for (const { camera } of witnesses) {
    const view = viewOf(camera, settingOf(camera));
    near(view.position, camera.position);
    const size = Math.hypot(...camera.boresight);
    near(
      view.boresight,
      camera.boresight.map((value) => value / size),
    );
  }
});

const bay: Camera = {
  name: 'B',
  title: 'Test',
  body: 'place',
  position: [0, 0, 0],
  boresight: [1, 0, 0],
  up: [0, 0, 1],
  field_of_view: 60 * degree,
  kind: 'camera',
  pane: null,
  drive: {
    zero: [1, 0, 0],
    lens: 0,
    pan: { least: -170 * degree, greatest: 170 * degree, rate: 0.2, slow: 0.02 },
    tilt: { least: -80 * degree, greatest: 80 * degree, rate: 0.2, slow: null },
    zoom: { least: 9 * degree, greatest: 77 * degree, rate: 0.1, slow: null },
  },
};

test('pan, tilt, zoom and field of view are burned in, and a drive at its stop says so', () => {
  expect(lensWords(bay, [-8.6 * degree, 6.8 * degree, 62 * degree])).toBe(
    'PAN −8.6  TILT +6.8\nZOOM 22 %  FOV 62.0°',
  );
  expect(lensWords(bay, [170 * degree, -80 * degree, 9 * degree])).toBe(
    'PAN +170.0 STOP  TILT −80.0 STOP\nZOOM 100 %  FOV 9.0°',
  );
  const { drive } = bay;
  expect(drive?.zoom && zoomed(drive.zoom, 77 * degree)).toBe(0);
  expect(lensWords({ ...bay, drive: null }, null)).toBe('FIXED  FOV 60.0°');
  const keel = drive && { ...bay, drive: { ...drive, pan: null, tilt: null } };
  expect(keel && lensWords(keel, [0, 0, 60 * degree])).toBe('FIXED\nZOOM 25 %  FOV 60.0°');
});

const placed = { position: [0, 0, 0], rotation: [0, 0, 0] } as const;

function body(name: string, at: Vec3, size: Vec3 = [1, 1, 1]): Body {
  const box: Shape = { ...placed, kind: 'box', material: 'metal', size };
  const info: BodyInfo = { name, shapes: [box] };
  const made = new Body(info, new Materials('low', new LambertLight(0)), 'low');
  made.setPose([...at, 1, 0, 0, 0], 0);
  return made;
}

function place(...others: Body[]): { sight: Sight; cameras: Cameras } {
  const bodies = [body('place', [0, 0, -50]), ...others];
  const cameras = new Cameras(
    [
      { ...bay, position: [0, 0, 50] },
      { ...eye, position: [0, 0, 50] },
    ],
    bodies,
  );
  return { sight: new Sight(cameras, bodies), cameras };
}

const eye: Camera = {
  ...bay,
  name: 'AFT',
  kind: 'window',
  drive: null,
  field_of_view: 120 * degree,
  pane: { distance: 1, width: 0.4, height: 0.4 },
};

test('a body in the picture is seen, one beside it, behind it or behind another body is not', () => {
  const { sight } = place(body('payload', [10, 0, 0]));
  expect(sight.body(bay, 'payload')).toBe(true);
  expect(place(body('payload', [10, -20, 0])).sight.body(bay, 'payload')).toBe(false);
  expect(place(body('payload', [-10, 0, 0])).sight.body(bay, 'payload')).toBe(false);
  expect(
    place(body('payload', [10, 0, 0]), body('wall', [5, 0, 0], [0.2, 8, 8])).sight.body(bay, 'payload'),
  ).toBe(false);
  expect(
    place(body('payload', [10, 0, 0]), body('post', [5, 0, 0], [0.2, 0.2, 8])).sight.body(bay, 'payload'),
  ).toBe(true);
  expect(sight.body(bay, 'nothing')).toBe(false);
});

test('a camera that has been turned sees what it is turned to', () => {
  const { sight, cameras } = place(body('payload', [0, -10, 0]));
  expect(sight.body(bay, 'payload')).toBe(false);
  cameras.put([[90 * degree, 0, 60 * degree]]);
  expect(sight.body(bay, 'payload')).toBe(true);
  near(sight.direction(bay), [0, -1, 0]);
  cameras.put([[90 * degree, 0, 9 * degree]]);
  expect(cameras.project('B', 1, [0, -10, 0]).visible).toBe(true);
  expect(cameras.project('B', 1, [1, -10, 0]).visible).toBe(false);
});

test('what is so near that it fills the picture is seen, and what it hides is not', () => {
  const wall = body('payload', [5, 40, 0], [0.2, 100, 100]);
  const { sight } = place(wall, body('post', [9, 0, 0]));
  expect(sight.body(bay, 'payload')).toBe(false);
  expect([...sight.ahead(bay)]).toEqual(['payload']);
  expect([...place().sight.ahead(bay)]).toEqual([]);
});

test('a gap is seen where any of it lies open', () => {
  const [a, b]: [Vec3, Vec3] = [
    [10, -2, 0],
    [10, 2, 0],
  ];
  expect(place().sight.line(bay, a, b)).toBe(true);
  expect(place(body('post', [5, 0, 0], [0.2, 0.5, 8])).sight.line(bay, a, b)).toBe(true);
  expect(place(body('wall', [5, 0, 0], [0.2, 8, 8])).sight.line(bay, a, b)).toBe(false);
  expect(place().sight.ends(bay, a, b)).toEqual([true, true]);
  expect(place(body('post', [5, -1.5, 0], [0.2, 2, 8])).sight.ends(bay, a, b)).toEqual([false, true]);
  expect(place(body('wall', [5, 0, 0], [0.2, 8, 8])).sight.ends(bay, a, b)).toEqual([false, false]);
});

test('through a window is seen what its pane leaves, and what stands before the pane hides nothing', () => {
  const ahead = place(body('payload', [10, 0, 0]), body('wall', [0.5, 0, 0], [0.2, 8, 8]));
  expect(ahead.sight.body(eye, 'payload')).toBe(true);
  // 0.2 m beside the middle at 1 m is 2 m beside it at 10 m.
  expect(place(body('payload', [10, 4, 0])).sight.body(eye, 'payload')).toBe(false);
  expect(
    place(body('wall', [1.5, 0, 0], [0.2, 8, 8]), body('payload', [10, 0, 0])).sight.body(eye, 'payload'),
  ).toBe(false);
});

test('lines of sight are apart by up to 90°, as lines', () => {
  expect(between([1, 0, 0], [0, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(90);
  expect(between([1, 0, 0], [-1, 0, 0], [0, 0, 0]) / degree).toBeCloseTo(0);
  expect(between([1, 0, 0], [-1, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(45);
});

function sighting(camera: string, lens: Vec3, sees: readonly Target[], turned = 0): Sighting {
  return { camera, lens, sees: new Set(sees), turned };
}

test('the best pair both see the gap and look at it from the most different sides', () => {
  const at = { gap: [0, 0, 0], tip: [1, 0, 0], payload: [2, 0, 0] } as const;
  const [a, b, c] = [
    sighting('A', [10, 0, 0], ['gap', 'tip']),
    sighting('B', [10, 2, 0], ['gap']),
    sighting('C', [9, 6, 0], ['gap'], 0.4),
  ];
  const square = sighting('D', [0, 10, 0], ['tip', 'payload']);
  const names = (sightings: readonly Sighting[]) =>
    bestPair(sightings, at)?.cameras.map(({ camera }) => camera);
  expect(names([a, b, c, square])).toEqual(['A', 'C']);
  expect(bestPair([a, b, c, square], at)?.targets).toEqual(['gap']);
  expect(bestPair([a, b, c], at)?.apart).toBeCloseTo(Math.atan2(6, 9));
  // Where no two see the gap, those that see tip and payload, then the tip.
  const two = sighting('E', [5, 5, 0], ['tip', 'payload']);
  expect(bestPair([a, square, two], at)?.targets).toEqual(['tip', 'payload']);
  expect(bestPair([a, square], at)?.targets).toEqual(['tip']);
  expect(bestPair([a], at)).toBeNull();
  expect(bestPair([a, b], { ...at, gap: null })).toBeNull();
});

test('of pairs that are nearly square the one counts whose pictures are turned the least', () => {
  const at = { gap: [0, 0, 0], tip: null, payload: null } as const;
  const angle = (degrees: number): Vec3 => [Math.cos(degrees * degree), Math.sin(degrees * degree), 0];
  const pair = bestPair(
    [
      sighting('A', angle(0), ['gap']),
      sighting('B', angle(90), ['gap'], 3),
      sighting('C', angle(75), ['gap'], 0.2),
    ],
    at,
  );
  expect(pair?.cameras.map(({ camera }) => camera)).toEqual(['A', 'C']);
});

test('the engineering view begins as its camera stands, goes round its middle and keeps level', () => {
  const camera: Camera = {
    ...bay,
    kind: 'engineering',
    drive: null,
    position: [-20, 20, 12],
    boresight: [20, -20, -12],
  };
  const orbit = new Orbit(camera);
  near(orbit.view.position, camera.position);
  const distance = Math.hypot(...orbit.view.position);
  orbit.turn(1, 0.2);
  expect(Math.hypot(...orbit.view.position)).toBeCloseTo(distance);
  orbit.approach(2);
  expect(Math.hypot(...orbit.view.position)).toBeCloseTo(distance / 2);
  orbit.turn(0, 10);
  expect(orbit.view.boresight[2]).toBeGreaterThan(-1);
  expect(orbit.view.up).toEqual([0, 0, 1]);
});

test('the engineering view goes round what it follows, and is shifted aside', () => {
  const orbit = new Orbit({
    ...bay,
    kind: 'engineering',
    drive: null,
    position: [0, -20, 0],
    boresight: [0, 20, 0],
  });
  const toBody = new Matrix4().makeTranslation(-1, 0, 0);
  orbit.turnTo([3, 0, 5], toBody);
  near(orbit.view.position, [2, -20, 5]);
  near(orbit.view.boresight, [0, 1, 0]);
  orbit.shift(0.1, 0);
  const [x = 0, y, z] = orbit.view.position;
  expect(x).toBeGreaterThan(2);
  near([2, y, z], [2, -20, 5]);
  orbit.follow([4, 0, 5], toBody);
  near(orbit.view.position, [x + 1, -20, 5]);
  orbit.turnTo(null, toBody);
  near(orbit.view.position, [0, -20, 0]);
});

test('held keys push the switches, opposite ones cancel', () => {
  expect(turningOf(new Set(), DEFAULTS.keyboard)).toEqual(still);
  expect(turningOf(new Set(['ArrowRight', 'ArrowUp', 'PageDown', 'KeyW']), DEFAULTS.keyboard)).toEqual({
    pan: 1,
    tilt: 1,
    zoom: -1,
  });
  expect(turningOf(new Set(['ArrowLeft', 'ArrowRight']), DEFAULTS.keyboard)).toEqual(still);
});

test('a camera is told to turn, again while the key is held, and to stop as soon as it is let go', () => {
  Object.assign(globalThis, { window: globalThis, document: { hidden: false } });
  const told: Record<string, unknown>[] = [];
  const said: string[] = [];
  let turning = { ...still };
  let camera = bay;
  const hand = new CameraHand(() => turning, {
    hand: () => ({ camera, slow: true }),
    barred: () => '',
    say: (text) => said.push(text),
    send: (command) => told.push({ ...command }),
    orbit: () => {},
  });
  hand.dispose();
  let now = performance.now();
  const tick = (ms: number) => {
    now += ms;
    hand.tick(now);
  };
  tick(15);
  expect(told).toEqual([]);
  turning = { ...still, pan: 1 };
  tick(15);
  tick(15);
  expect(told).toEqual([{ type: 'drive_camera', camera: 'B', ...still, pan: 1, slow: true }]);
  tick(100);
  expect(told).toHaveLength(2);
  turning = still;
  tick(15);
  tick(500);
  expect(told.slice(2)).toEqual([{ type: 'drive_camera', camera: 'B', ...still, slow: true }]);
  camera = { ...bay, name: 'X', drive: null };
  turning = { ...still, tilt: 1 };
  tick(15);
  tick(15);
  expect(told).toHaveLength(3);
  expect(said).toEqual(['X is fixed.']);
});

test('a drag pushes the switches as far as it went from where it began, until it is let go', () => {
  const drag = new CameraDrag();
  expect(drag.turning(0)).toEqual(still);
  drag.press(1, { x: 200, y: 150 }, 300);
  drag.move(1, { x: 202, y: 149 });
  expect(drag.turning(0)).toEqual(still);
  drag.move(1, { x: 230, y: 90 });
  const { pan, tilt, zoom } = drag.turning(0);
  expect(tilt / pan).toBeCloseTo(2);
  expect(zoom).toBe(0);
  expect(drag.line).toEqual({ from: { x: 200, y: 150 }, to: { x: 230, y: 90 } });
  drag.move(1, { x: -900, y: 900 });
  expect(drag.turning(0)).toEqual({ pan: -1, tilt: -1, zoom: 0 });
  drag.lift(1);
  expect(drag.turning(0)).toEqual(still);
  expect(drag.line).toBeNull();
});

test('a notch of the wheel zooms for a moment, and one the other way ends it', () => {
  const drag = new CameraDrag();
  drag.turnWheel(1, 1000);
  expect(drag.turning(1050).zoom).toBe(1);
  drag.turnWheel(-1, 1060);
  expect(drag.turning(1070).zoom).toBe(-1);
  expect(drag.turning(1500)).toEqual(still);
  for (let i = 0; i < 50; i += 1) drag.turnWheel(1, 2000);
  expect(drag.turning(2600)).toEqual(still);
});

test('two fingers pinch: apart zooms in, together out, and neither pans', () => {
  const drag = new CameraDrag();
  drag.press(1, { x: 100, y: 100 }, 300);
  drag.press(2, { x: 200, y: 100 }, 300);
  expect(drag.turning(0)).toEqual(still);
  drag.move(2, { x: 400, y: 100 });
  expect(drag.turning(0)).toEqual({ pan: 0, tilt: 0, zoom: 1 });
  drag.move(2, { x: 170, y: 100 });
  expect(drag.turning(0).zoom).toBeCloseTo(Math.log(0.7) / Math.log(2));
  drag.release();
  expect(drag.turning(0)).toEqual(still);
});

test('keys and a drag push the same switches, no farther than they go', () => {
  expect(together({ pan: 1, tilt: -0.5, zoom: 0 }, { pan: 0.7, tilt: 0.5, zoom: -1 })).toEqual({
    pan: 1,
    tilt: 0,
    zoom: -1,
  });
});

test('a page is asked by its address to show one thing alone', () => {
  expect(tornHere('')).toBeNull();
  expect(tornHere('?view=mon1')).toBe(0);
  expect(tornHere('?view=mon2&quality=low')).toBe(1);
  expect(tornHere('?view=matrix')).toBe('matrix');
  expect(tornHere('?view=else')).toBeNull();
});
