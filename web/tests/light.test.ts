import { MeshBasicMaterial } from 'three';
import { expect, test } from 'vitest';
import type { LightCondition, Vec3 } from '../src/link/protocol';
import { toggled } from '../src/panel/rail/light';
import { agx, LIGHT_OF } from '../src/scene/agx';
import { Body, lampCount } from '../src/scene/bodies';
import { daylightOf, FULL_SUN } from '../src/scene/daylight';
import { Exposure, KEY, metered, RANGE, TIME_CONSTANT_S } from '../src/scene/exposure';
import { lampsOf } from '../src/scene/floodlights';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';

function condition(name: string, strength: number, to_sun: Vec3 = [0, 0, 2]): LightCondition {
  return {
    name,
    to_sun,
    nadir: [0, -3, 0],
    sun: { colour: '#ffffff', strength },
    earthshine: { colour: '#ffffff', strength: 0.5 },
    sky: { above: '#ffffff', below: '#000000', strength: 0.3 },
    exposure: 1,
    source: 'a test',
  };
}

const DAY = condition('day', FULL_SUN);
const NIGHT = condition('night', 0);
const placed = { position: [0, 0, 0], rotation: [0, 0, 0] } as const;
const lamp = { ...placed, kind: 'light', radius: 0.1, reach: 10, intensity: 2 } as const;
const FLOOD = { ...lamp, position: [1, 2, 3], cone: Math.PI, switch: 'floods' } as const;
const SPOT = { ...lamp, rotation: [0, 0, Math.PI / 2], cone: 0.6, switch: 'spot' } as const;

function lighted(): { light: LambertLight; body: Body; materials: Materials } {
  const info = { name: 'lamp body', shapes: [FLOOD, SPOT], details: [] };
  const light = new LambertLight(lampCount([info]));
  const materials = new Materials('low', light);
  const body = new Body(info, materials, 'low');
  light.take(lampsOf([body]));
  return { light, body, materials };
}

const uniform = (light: LambertLight, name: string) => light.uniforms[name]?.value;

test('the error for an unknown light condition names the condition', () => {
  expect(() => daylightOf([DAY], 'dusk')).toThrow('dusk');
});

test('the low profile has sun, Earth and sky light of the condition', () => {
  const { light } = lighted();
  light.set(daylightOf([DAY, NIGHT], 'day'), new Set());
  expect(uniform(light, 'toSun')).toMatchObject({ x: 0, y: 0, z: 1 });
  expect(uniform(light, 'nadir')).toMatchObject({ x: 0, y: -1, z: 0 });
  expect(uniform(light, 'sun').r).toBeCloseTo(FULL_SUN / Math.PI, 12);
  light.set(daylightOf([DAY, NIGHT], 'night'), new Set());
  expect(uniform(light, 'sun').r).toBe(0);
  expect(uniform(light, 'earthshine').g).toBeCloseTo(0.5 / Math.PI, 12);
});

test('only lamps that are switched on are computed, and only in the dark', () => {
  const { light } = lighted();
  expect(light.room).toBe(2);
  const count = (name: string, on: readonly string[]) => {
    light.set(daylightOf([DAY, NIGHT], name), new Set(on));
    return uniform(light, 'lit_lamps');
  };
  expect(count('day', ['floods', 'spot'])).toBe(0);
  expect(count('night', ['floods', 'spot'])).toBe(2);
  expect(count('night', ['floods'])).toBe(1);
  expect(count('night', [])).toBe(0);
});

test('a lamp and the axis of its beam move with their body', () => {
  const { light, body } = lighted();
  light.set(daylightOf([NIGHT], 'night'), new Set(['floods', 'spot']));
  const half = Math.SQRT1_2;
  body.setPose([10, 0, 0, half, 0, 0, half], 0); // turned by a quarter about z
  light.follow();
  const [flood, spot] = uniform(light, 'lamps');
  expect(flood.x).toBeCloseTo(8, 12);
  expect(flood.y).toBeCloseTo(1, 12);
  expect(spot.x).toBeCloseTo(10, 12);
  const [round, beam] = uniform(light, 'beams');
  expect(round.w).toBe(0);
  expect(beam.x).toBeCloseTo(-1, 12);
  expect(beam.w).toBeGreaterThan(1);
});

test('a lamp face changes only with its own switch', () => {
  const { materials } = lighted();
  const face = (name: string) => {
    const found = materials.material(`glow ${name}`);
    return found instanceof MeshBasicMaterial ? found.color.r : Number.NaN;
  };
  materials.lightUp(new Set(['spot']));
  expect(face('spot')).toBe(1);
  expect(face('floods')).toBeLessThan(0.2);
});

test('switching a lamp keeps the order of the lamps', () => {
  expect(toggled(['a', 'b', 'c'], ['a', 'c'], 'b')).toEqual(['a', 'b', 'c']);
  expect(toggled(['a', 'b', 'c'], ['a', 'c'], 'a')).toEqual(['c']);
});

test('the exposure ignores black space; a uniform picture gets the light `KEY`', () => {
  expect(metered([KEY, KEY])).toBeCloseTo(0, 12);
  expect(metered([KEY / 4, 0, 0, 0])).toBeCloseTo(2, 12);
  expect(metered([0, 0])).toBeNull();
});

test('the first picture sets the exposure; later ones change it exponentially', () => {
  const exposure = new Exposure();
  exposure.follow(0, 0, null);
  expect(exposure.settled).toBe(false);
  exposure.meter(-1);
  expect([exposure.settled, exposure.stops]).toEqual([true, -1]);
  exposure.meter(1);
  for (let i = 1; i <= 16; i++) exposure.follow((i * TIME_CONSTANT_S) / 16, 0, null);
  expect(exposure.stops).toBeCloseTo(1 - 2 / Math.E, 9);
});

test('an exposure stays within its range about the initial value', () => {
  const exposure = new Exposure();
  exposure.follow(0, 2, null);
  exposure.meter(20);
  expect(exposure.stops).toBe(2 + RANGE);
  exposure.meter(-20);
  for (let t = 0; t < 30; t++) exposure.follow(t, 2, null);
  expect(exposure.stops).toBeCloseTo(2 - RANGE, 9);
});

test('a lock holds the exposure; after unlock it follows the picture', () => {
  const exposure = new Exposure();
  exposure.follow(0, 0, 1.5);
  exposure.meter(-1);
  exposure.follow(1, 0, 1.5);
  expect(exposure.stops).toBe(1.5);
  exposure.follow(1 + TIME_CONSTANT_S, 0, null);
  expect(exposure.stops).toBeCloseTo(-1 + 2.5 / Math.E, 9);
});

test('the next picture after a jump in time sets the exposure', () => {
  const exposure = new Exposure();
  exposure.follow(5, 0, null);
  exposure.meter(-1);
  exposure.follow(1, 0, null);
  expect(exposure.settled).toBe(false);
  exposure.meter(1);
  expect(exposure.stops).toBe(1);
});

test('the next picture after a change of light sets the exposure', () => {
  const exposure = new Exposure();
  exposure.follow(0, 0, null);
  exposure.meter(-1);
  exposure.renew();
  exposure.follow(0.02, 1.5, null);
  expect(exposure.settled).toBe(false);
  exposure.meter(2);
  expect(exposure.stops).toBe(2);
});

test('a black picture has the initial exposure of the light', () => {
  const exposure = new Exposure();
  exposure.follow(0, 2, null);
  exposure.meter(null);
  expect(exposure.stops).toBe(2);
});

test('the inverse of the tone map returns the grey value of a byte', () => {
  for (const light of [0.02, 0.18, 0.5, 1, 3]) {
    const shown = agx(light);
    const srgb = shown <= 0.0031308 ? 12.92 * shown : 1.055 * shown ** (1 / 2.4) - 0.055;
    const found = LIGHT_OF[Math.round(255 * srgb)] ?? 0;
    expect(Math.abs(Math.log2(found / light))).toBeLessThan(0.06);
  }
});
