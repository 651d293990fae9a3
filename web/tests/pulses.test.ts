import { describe, expect, it, vi } from 'vitest';
import { Controllers } from '../src/input/controllers';
import { AXES, isZero, PAN, X, YAW, ZERO } from '../src/input/deflection';
import { Pulses } from '../src/input/pulses';
import { plugged } from './gamepads';

const at = (axis: number, value: number) => ZERO.map((_, i) => (i === axis ? value : 0));

describe('PULSE', () => {
  it.each([0, 1, 2, 3, 4, 5, 6])(
    'asks for one pulse at each push of axis %i, and deflects no stick',
    (axis) => {
      const pulses = new Pulses();
      const asked = [0, 1, 1, 0.6, 0, -0.2, -1, -1, 0, 1].map((value) => {
        expect(isZero(pulses.take(at(axis, value), true))).toBe(true);
        return pulses.pushed[axis];
      });
      expect(asked).toEqual([0, 1, 0, 0, 0, 0, -1, 0, 0, 1]);
    },
  );

  it('asks once however the axis trembles while it is pushed', () => {
    const pulses = new Pulses();
    const trembling = [0, 0.49, 0.5, 0.4, 0.6, 0.3, 0.9].map((value) => {
      pulses.take(at(X, value), true);
      return pulses.pushed[X];
    });
    expect(trembling.filter((sign) => sign !== 0)).toEqual([1]);
  });

  it('leaves a stick that is deflected when it ends at zero until the stick was centred', () => {
    const pulses = new Pulses();
    pulses.take(ZERO, true);
    pulses.take(at(X, 1), true);
    expect([1, 0.4, 0.1, 0, 0.7].map((value) => pulses.take(at(X, value), false)[X])).toEqual([
      0, 0, 0, 0, 0.7,
    ]);
  });

  it('asks for no pulse of a stick that is deflected when it begins, and lets this stick go', () => {
    const pulses = new Pulses();
    expect(pulses.take(at(YAW, 1), false)[YAW]).toBe(1);
    expect(isZero(pulses.take(at(YAW, 1), true))).toBe(true);
    expect(pulses.asks).toBe(false);
    pulses.take(ZERO, true);
    pulses.take(at(YAW, 1), true);
    expect(pulses.pushed[YAW]).toBe(1);
  });

  it('leaves the cameras as they are', () => {
    const pulses = new Pulses();
    for (let axis: number = PAN; axis < AXES.length; axis += 1) {
      expect(pulses.take(at(axis, 0.7), true)[axis]).toBe(0.7);
      expect(pulses.asks).toBe(false);
    }
  });

  it('needs only a tap of a key, and acts for every device while its key is held', () => {
    vi.stubGlobal('window', { addEventListener() {} });
    const world = plugged({ id: 'Left' });
    const controllers = new Controllers(() => {}, { moved() {}, taken: () => false });
    controllers.poll(0, 0.01);
    controllers.keyboard.held.add('ShiftLeft');
    controllers.poll(10, 0.01);
    controllers.keyboard.held.add('KeyW');
    expect(isZero(controllers.poll(11, 0.001))).toBe(true);
    expect(controllers.pulses.pushed[X]).toBe(1);
    controllers.keyboard.held.delete('KeyW');
    controllers.poll(12, 0.001);
    world.axes(0, 0, 1, 0, 0); // towards the operator
    controllers.poll(20, 0.01);
    expect(controllers.pulses.pushed[X]).toBe(-1);
    controllers.keyboard.held.clear();
    expect(isZero(controllers.poll(30, 0.01))).toBe(true);
    expect(controllers.shown.pulsing).toBe(false);
  });
});
