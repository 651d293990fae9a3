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
