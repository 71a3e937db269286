// Channels: what is packed is read back, number by number.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { unpackInts } from '../../sim/page/web/src/channels.js';
import { packInts } from './payload_writer.mjs';
import { randomFrom } from './made_up_rows.mjs';

test('numbers of 32 bits come back', () => {
  const random = randomFrom(3);
  for (const size of [1, 100, 40000, 2 ** 31 - 1]) {
    const values = Array.from({ length: 500 }, () => Math.round((random() * 2 - 1) * size) + 0);
    assert.deepEqual([...unpackInts(packInts(values))], values);
  }
});

test('the ends of the range and missing values come back', () => {
  const values = [0, 2 ** 31 - 1, -(2 ** 31), -(2 ** 31), 5, -1, 2 ** 31 - 1];
  assert.deepEqual([...unpackInts(packInts(values))], values);
});

test('the example of the reference is read', () => {
  // 10, 12, 9: differences 10, 2, -3; zigzag 20, 4, 5; one plane
  assert.deepEqual([...packInts([10, 12, 9])], [1, 20, 4, 5]);
  // 1000, 1300, 700: differences 1000, 300, -600; zigzag 2000, 600, 1199; two planes
  assert.deepEqual([...packInts([1000, 1300, 700])], [2, 208, 88, 175, 7, 2, 4]);
});

test('a channel of a wrong length is refused', () => {
  assert.throws(() => unpackInts(Uint8Array.of(2, 1, 2, 3)), /damaged/);
  assert.throws(() => unpackInts(Uint8Array.of(9, 1, 2, 3)), /damaged/);
});
