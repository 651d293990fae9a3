import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import type { JointInfo } from '../src/link/protocol';
import type { Command } from '../src/link/socket';
import { joints as jointsGroup } from '../src/panel/joints/joints';
import { masterGroup } from '../src/panel/joints/master';
import type { Desk, Part, View } from '../src/panel/parts/part';
import { payloadTable, servoRates } from '../src/panel/target/payload-table';
import {
  coordinateNumber,
  coordinatesSaid,
  coordinateText,
  jointCalled,
  keySteps,
  motionText,
  rangeText,
  rateText,
} from '../src/words/joint';
import type { Units } from '../src/words/units';
import { frameOf } from './panel-frames';
import { type SmallElement, small, useSmallPage } from './small-page';
import { FEET, SI } from './worksite';

const DEGREE = Math.PI / 180;
const PARTS = { stick: null, torque: null, holding: null };
const elbow: JointInfo = {
  ...{ ...PARTS, name: 'elbow', label: 'Elbow', slides: false },
  ...{ hard: [-160 * DEGREE, 20 * DEGREE], soft: [-158 * DEGREE, 18 * DEGREE] },
  ...{ reach: [-156 * DEGREE, 16 * DEGREE], coarse: 0.02, vernier: 0.01, servo: 3 * DEGREE },
};
const rail: JointInfo = {
  ...{ ...PARTS, name: 'long_rail', label: 'Rail', slides: true },
  ...{ hard: [-6, 6], soft: [-5.9, 5.9], reach: [-5.8, 5.8], coarse: 0.1, vernier: 0.03, servo: 0.2 },
};

describe('a coordinate', () => {
  it('of a joint that turns is an angle in all units', () => {
    for (const units of [FEET, SI]) expect(coordinateText(elbow, -0.5, units)).toBe('−28.6');
  });

  it('of a joint that slides is a length in the page’s units', () => {
    expect([coordinateText(rail, 0.5, SI), coordinateText(rail, -0.5, FEET)]).toEqual(['+0.500', '−19.7']);
  });

  it('has a number for a slider, and is said with its unit', () => {
    expect([coordinateNumber(elbow, -0.5, SI), coordinateNumber(rail, -0.5, FEET)]).toEqual([
      '-28.6',
      '-19.7',
    ]);
    expect(coordinatesSaid(elbow, 0.5, 0, SI)).toBe('+28.6 degrees, joint at +0.0');
    expect(coordinatesSaid(rail, 0.5, 0, SI)).toBe('+0.500 metres, joint at +0.000');
    expect(coordinatesSaid(rail, 0.5, 0, FEET)).toBe('+19.7 inches, joint at +0.0');
  });
});

test('limits, rates and motions have the units of the joint', () => {
  expect(rangeText(elbow, SI)).toBe(
    'Elbow: reach −156.0° to +16.0°, soft −158.0° to +18.0°, hard −160.0° to +20.0°',
  );
  expect(rangeText(rail, SI)).toBe(
    'Rail: reach −5.800 m to +5.800 m, soft −5.900 m to +5.900 m, hard −6.000 m to +6.000 m',
  );
  expect(rangeText(rail, FEET)).toContain('reach −228.3 in to +228.3 in');
  expect([rateText(elbow, 0.02, SI), rateText(rail, 0.2, SI), rateText(rail, 0.2, FEET)]).toEqual([
    '1.15',
    '0.200',
    '0.66',
  ]);
  expect([motionText(elbow, -0.2, SI), motionText(elbow, 0.2, SI, 0)]).toEqual(['11.5°', '11°']);
  expect([motionText(rail, -0.2, SI), motionText(rail, 2, FEET)]).toEqual(['20 cm', '6.6 ft']);
});

test('the greatest servo rates have a unit after each group of joints', () => {
  expect(servoRates([elbow, elbow], FEET)).toBe('3.00  3.00 °/s');
  expect(servoRates([rail, elbow, elbow, rail], SI)).toBe('0.200 m/s, 3.00  3.00 °/s, 0.200 m/s');
});

test('a joint is found by the name that texts have', () => {
  expect(jointCalled('long rail', [elbow, rail])).toBe(rail);
  expect(jointCalled('target', [elbow, rail])).toBeUndefined();
});

describe('groups of the page', () => {
  beforeEach(useSmallPage);
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  const payload = {
    ...{ id: 0, name: 'no payload', mass: 0, translation: [0.3, 0.1], rotation: [0.05, 0.02] },
    ...{ coarse: [0.1, 0.02], vernier: [0.03, 0.01] },
  };

  function desk(shown: readonly JointInfo[]) {
    const sent: Command[] = [];
    const welcome = {
      ...{ joints: shown, payloads: [payload], modes: [], flexures: [] },
      ...{ plant: 'kinematic', work: { stand: null } },
    };
    return { desk: { welcome, send: (command: Command) => sent.push(command) } as unknown as Desk, sent };
  }

  function draw(group: Pick<Part, 'element' | 'bars' | 'values'>, units: Units): SmallElement {
    const frame = frameOf({
      ...{ angles: [0.5, -0.5], angles_commanded: [0.6, -0.5], rates: [0, 0], rates_commanded: [0, 0] },
      ...{ rate_limits: [0.2, 0.05], zones: [0, 0], motions: [], work: { stand: null, master: [0.7, 0] } },
      ...{ mode: 'MASTER', joint: 0, dynamics: null, brakes: false },
    });
    const view = { frame, units, controllers: { names: null } } as unknown as View;
    group.bars?.(view);
    group.values?.(view);
    return small(group.element);
  }

  /** Texts of the cells in the body of a table. */
  const cells = (element: SmallElement, selector: string) =>
    element.querySelectorAll(selector).map(({ textContent }) => textContent);

  it('show a joint that slides with its unit', () => {
    const group = jointsGroup(desk([rail, elbow]).desk);
    const element = draw(group, SI);
    expect(cells(element, 'tbody th')).toEqual(['Rail m', 'Elbow']);
    expect(cells(element, 'td.angle')).toEqual(['+0.500', '−28.6']);
    expect(element.querySelector('td.scale')?.getAttribute('title')).toBe(rangeText(rail, SI));
    expect(cells(element, 'thead th')).toContain('deg');
    draw(group, FEET);
    expect(cells(element, 'tbody th')).toEqual(['Rail in', 'Elbow']);
    expect(cells(element, 'td.angle')).toEqual(['+19.7', '−28.6']);
    expect(element.querySelector('td.scale')?.getAttribute('title')).toBe(rangeText(rail, FEET));
    expect(cells(draw(jointsGroup(desk([rail, rail]).desk), SI), 'thead th')).not.toContain('deg');
  });

  it('send metres from the slider of a joint that slides', () => {
    const { desk: own, sent } = desk([rail, elbow]);
    const element = draw(masterGroup(own), FEET);
    expect(cells(element, 'td.commanded')).toEqual(['+27.6', '+0.0']);
    const [first, second] = element.querySelectorAll('.slider');
    expect(first?.getAttribute('aria-valuemin')).toBe('-236.2');
    expect(second?.getAttribute('aria-valuemax')).toBe('20');
    const press = (key: string) => first?.dispatch('keydown', { key, preventDefault() {} });
    press('ArrowRight');
    expect(sent).toEqual([{ type: 'master', angles: [0.7 + keySteps(rail)[0], 0] }]);
    press('End');
    press('Tab');
    expect(first?.getAttribute('aria-valuenow')).toBe('27.6');
  });

  it('show rate limits of a joint that slides as speeds', () => {
    const table = payloadTable(desk([rail, elbow]).desk.welcome);
    const frame = frameOf({ display: { payload_id: 0, por_offset: [0, 0, 0] } });
    table.set(frame, SI);
    const element = small(table.element);
    expect(cells(element, 'thead th').slice(-2)).toEqual(['Rail m/s', 'Elbow']);
    expect(cells(element, 'tbody td').slice(-2)).toEqual(['0.100 / 0.030', '1.15 / 0.57']);
    expect(element.querySelector('small')?.textContent).toContain('joints in m/s or °/s,');
    table.set(frame, FEET);
    expect(cells(element, 'tbody td').slice(-2)).toEqual(['0.33 / 0.10', '1.15 / 0.57']);
  });
});
