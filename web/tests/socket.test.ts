import { expect, test } from 'vitest';
import { parse } from '../src/link/socket';

test('parsing rejects a message of an unknown type by its name', () => {
  expect(parse('{"type":"refused","seq":-1,"text":"No."}')).toMatchObject({ seq: -1 });
  expect(() => parse('{"type":"rumour"}')).toThrow('rumour');
  expect(() => parse(new ArrayBuffer(1))).toThrow('not text');
});
