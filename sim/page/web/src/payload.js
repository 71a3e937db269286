// The data inside the page: base64 of gzip of a header and blobs (docs/reference/report_payload.md).

const MAGIC = 'DOCKREP1';
const FORMAT = 1;

/** @typedef {{offset: number, length: number}} Blob */
/** @typedef {{header: any, blobs: Blobs}} Payload */

/** The bytes behind the header. */
export class Blobs {
  /** @param {ArrayBuffer} buffer @param {number} begin */
  constructor(buffer, begin) {
    this.buffer = buffer;
    this.begin = begin;
  }

  /** @param {Blob} blob @param {number} [unit] bytes of one value @returns {[ArrayBuffer, number, number]} */
  range(blob, unit = 1) {
    const { offset, length } = blob ?? {};
    const fits =
      Number.isInteger(offset) &&
      Number.isInteger(length) &&
      offset >= 0 &&
      length >= 0 &&
      offset % 4 === 0 &&
      length % unit === 0 &&
      this.begin + offset + length <= this.buffer.byteLength;
    if (!fits) throw new Error('a part of the data lies outside the file');
    return [this.buffer, this.begin + offset, length / unit];
  }

  /** @param {Blob} blob */
  bytes(blob) {
    return new Uint8Array(...this.range(blob));
  }
  /** @param {Blob} blob */
  i16(blob) {
    return new Int16Array(...this.range(blob, 2));
  }
  /** @param {Blob} blob */
  u16(blob) {
    return new Uint16Array(...this.range(blob, 2));
  }
  /** @param {Blob} blob */
  i32(blob) {
    return new Int32Array(...this.range(blob, 4));
  }
  /** @param {Blob} blob */
  u32(blob) {
    return new Uint32Array(...this.range(blob, 4));
  }
  /** @param {Blob} blob */
  f32(blob) {
    return new Float32Array(...this.range(blob, 4));
  }

  /** 64-bit numbers may begin at any multiple of 4, so they are copied. @param {Blob} blob */
  f64(blob) {
    const [buffer, begin, count] = this.range(blob, 8);
    return new Float64Array(buffer.slice(begin, begin + 8 * count));
  }
}

/** @param {string} text @returns {Uint8Array} */
function fromBase64(text) {
  const built_in = /** @type {any} */ (Uint8Array).fromBase64;
  if (built_in) return built_in.call(Uint8Array, text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array} packed @returns {Promise<ArrayBuffer>} */
function unzip(packed) {
  const stream = new Blob([/** @type {any} */ (packed)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/**
 * Reads the data. Throws an Error whose message is the reason.
 * @param {string} text base64
 * @returns {Promise<Payload>}
 */
export async function readPayload(text) {
  if (text.trim() === '') throw new Error('the file holds no data');
  let buffer;
  try {
    buffer = await unzip(fromBase64(text.trim()));
  } catch {
    throw new Error('the data cannot be unpacked');
  }
  return parsePayload(buffer);
}

/** @param {ArrayBuffer} buffer @returns {Payload} */
export function parsePayload(buffer) {
  if (buffer.byteLength < 12) throw new Error('the data is too short');
  const magic = new TextDecoder('latin1').decode(new Uint8Array(buffer, 0, 8));
  if (magic !== MAGIC) throw new Error('the data does not begin as a report does');
  const length = new DataView(buffer).getUint32(8, true);
  if (12 + length > buffer.byteLength) throw new Error('the data ends within its header');
  let header;
  try {
    header = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(new Uint8Array(buffer, 12, length)));
  } catch {
    throw new Error('the header of the data cannot be read');
  }
  if (header.format !== FORMAT)
    throw new Error(`the data has format ${header.format}, this page reads ${FORMAT}`);
  return { header, blobs: new Blobs(buffer, Math.ceil((12 + length) / 4) * 4) };
}
