// Channels: whole numbers, packed as differences (docs/reference/report_payload.md#channels).

const MISSING = -0x80000000;

/** @typedef {{offset: number, length: number, quantum: number}} Channel */

/**
 * @param {Uint8Array} bytes the number of planes, then the planes
 * @returns {Int32Array}
 */
export function unpackInts(bytes) {
  if (bytes.length === 0) return new Int32Array(0);
  const planes = bytes[0];
  const count = (bytes.length - 1) / planes;
  if (planes < 1 || planes > 4 || !Number.isInteger(count))
    throw new Error('a channel of the data is damaged');
  const values = new Int32Array(count);
  let last = 0;
  for (let i = 0; i < count; ++i) {
    let zigzag = 0;
    for (let plane = 0; plane < planes; ++plane) zigzag |= bytes[1 + plane * count + i] << (8 * plane);
    last = (last + ((zigzag >>> 1) ^ -(zigzag & 1))) | 0;
    values[i] = last;
  }
  return values;
}

/**
 * The numbers of a channel, NaN where it has none.
 * @param {import('./payload.js').Blobs} blobs
 * @param {Channel} channel
 * @param {number} [expected] how many numbers it must have
 * @returns {Float64Array}
 */
export function readChannel(blobs, channel, expected) {
  const ints = unpackInts(blobs.bytes(channel));
  if (expected !== undefined && ints.length !== expected) throw new Error('a channel of the data is damaged');
  const values = new Float64Array(ints.length);
  for (let i = 0; i < ints.length; ++i) values[i] = ints[i] === MISSING ? NaN : ints[i] * channel.quantum;
  return values;
}
