import { describe, expect, it } from 'vitest';
import { Control } from '../src/page/control';

describe('control', () => {
  const operator = () => {
    const control = new Control();
    control.role = { ...control.role, flying: true };
    return control;
  };

  it('belongs only to the operator', () => {
    expect(new Control().flies).toBe(false);
    expect(operator().flies).toBe(true);
  });

  it('says why nothing moves, and what to do', () => {
    const control = new Control();
    expect(control.bar).toContain('unattended. Press “Ask for the sticks”');
    control.role = { ...control.role, flier: 2, names: [{ number: 2, name: 'Anna' }] };
    expect(control.bar).toContain('Anna flies');
    control.role = { ...control.role, may_fly: false };
    expect(control.bar).toContain('is for observing');
    control.link = { kind: 'lost', attempt: 3 };
    expect(control.bar).toContain('start it again');
  });

  it.each<[string, (control: Control) => void]>([
    ['the link is lost', (control) => (control.link = { kind: 'lost', attempt: 1 })],
    ['another scenario is being prepared', (control) => (control.leaving = true)],
    ['the window is too narrow', (control) => (control.tooNarrow = true)],
  ])('is off while %s', (_, change) => {
    const control = operator();
    change(control);
    expect(control.flies).toBe(false);
  });
});
