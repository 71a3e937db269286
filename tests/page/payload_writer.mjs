// Packs a report's data as docs/reference/report_payload.md says, and puts it into the page.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const template = new URL('../../sim/page/web/page.html', import.meta.url);
const MISSING = -0x80000000;

/** Collects blobs, each at a multiple of 4. */
export class BlobStore {
  constructor() {
    this.parts = [];
    this.size = 0;
  }

  /** @param {ArrayBufferView} values a typed array @returns {{offset: number, length: number}} */
  add(values) {
    const bytes = Buffer.from(values.buffer, values.byteOffset, values.byteLength);
    const blob = { offset: this.size, length: bytes.length };
    const padding = (4 - (bytes.length % 4)) % 4;
    this.parts.push(bytes, Buffer.alloc(padding));
    this.size += bytes.length + padding;
    return blob;
  }

  /** Numbers as a channel; NaN is a missing value. */
  channel(values, quantum) {
    return {
      ...this.add(packInts(values.map((v) => (Number.isNaN(v) ? MISSING : Math.round(v / quantum))))),
      quantum,
    };
  }
}

/** @param {number[]} values whole numbers of 32 bits @returns {Uint8Array} */
export function packInts(values) {
  let last = 0,
    all = 0;
  const zigzag = Uint32Array.from(values, (value) => {
    const step = (value - last) | 0;
    last = value | 0;
    const code = ((step << 1) ^ (step >> 31)) >>> 0;
    all = (all | code) >>> 0;
    return code;
  });
  const planes = all >>> 24 ? 4 : all >>> 16 ? 3 : all >>> 8 ? 2 : 1;
  const bytes = new Uint8Array(1 + planes * zigzag.length);
  bytes[0] = planes;
  for (let plane = 0; plane < planes; ++plane) {
    zigzag.forEach((code, i) => {
      bytes[1 + plane * zigzag.length + i] = (code >>> (8 * plane)) & 255;
    });
  }
  return bytes;
}

/** @param {object} header @param {BlobStore} blobs @returns {Buffer} before gzip */
export function packPayload(header, blobs) {
  const text = Buffer.from(JSON.stringify(header), 'utf8');
  const head = Buffer.alloc(12);
  head.write('DOCKREP1', 'latin1');
  head.writeUInt32LE(text.length, 8);
  return Buffer.concat([head, text, Buffer.alloc((4 - ((12 + text.length) % 4)) % 4), ...blobs.parts]);
}

/** @param {Buffer} payload @param {number} [level] of gzip @returns {string} the page with this data */
export function pageWith(payload, level = 6) {
  return fillPage(gzipSync(payload, { level }).toString('base64'));
}

/** @param {string} text in the place of the data */
export function fillPage(text) {
  return readFileSync(template, 'utf8').replace('@PAYLOAD@', () => text);
}
