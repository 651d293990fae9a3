import { expect, test } from 'vitest';
import { lensWords, zoomed } from '../src/words/lens';
import { bay, degree } from './camera-values';

test('the picture shows pan, tilt, zoom, field of view and drive stops', () => {
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
