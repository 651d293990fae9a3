import { afterEach, expect, test, vi } from 'vitest';
import { startOrNotice } from '../src/page/notice';
import { SmallElement, useSmallPage } from './small-page';

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

test('a page that cannot start says why and what to do', () => {
  useSmallPage();
  vi.spyOn(console, 'error').mockImplementation(() => {});
  const root = new SmallElement('div');
  startOrNotice(root as unknown as HTMLElement, () => root.append('a page'));
  expect(root.textContent).toBe('a page');
  startOrNotice(root as unknown as HTMLElement, () => {
    throw new Error('WebGL 2 for the pictures is missing.');
  });
  expect(root.textContent).toContain('cannot start: WebGL 2 for the pictures is missing. Close');
  expect(root.textContent).toContain('reload this page');
});
