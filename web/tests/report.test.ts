import { describe, expect, it } from 'vitest';
import type { Command } from '../src/link/socket';
import { Report } from '../src/page/report';

describe('a report of the shown cameras', () => {
  it('is sent once a second, and at once when a monitor changes its camera', () => {
    const sent: Command[] = [];
    const report = new Report((command) => sent.push(command));
    for (let now = 5000; now < 8000; now += 100) report.update(now, [['A'], ['B', 'C']], now);
    expect(sent.length).toBe(3);
    report.update(null, [['A'], ['B', 'D']], 8000 - 50);
    expect(sent.at(-1)).toEqual({ type: 'shown', latency_ms: null, monitors: [['A'], ['B', 'D']] });
    report.update(null, [['A'], ['B', 'D']], 8000);
    expect(sent.length).toBe(4);
  });
});
