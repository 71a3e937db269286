// Meshes and images for made-up reports: boxes, cylinders, a picture of the board.
import { crc32, deflateSync } from './png_parts.mjs';

/** A box with these half sizes about a centre. */
export function box(hx, hy, hz, [cx, cy, cz] = [0, 0, 0]) {
  const vertices = [],
    triangles = [];
  for (let i = 0; i < 8; ++i)
    vertices.push(cx + (i & 1 ? hx : -hx), cy + (i & 2 ? hy : -hy), cz + (i & 4 ? hz : -hz));
  for (const [a, b, c, d] of [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ]) {
    triangles.push(a, b, c, a, c, d);
  }
  return { vertices, triangles };
}

/** A wheel about y: a closed cylinder with paddles. */
export function wheel(radius, width, paddles = 12) {
  const parts = [cylinder(radius * 0.9, width)];
  for (let k = 0; k < paddles; ++k) {
    const turn = (2 * Math.PI * k) / paddles;
    const paddle = box(radius * 0.06, width / 2, 0.006, [radius * 0.94, 0, 0]);
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    for (let i = 0; i < paddle.vertices.length; i += 3) {
      const [x, , z] = paddle.vertices.slice(i, i + 3);
      paddle.vertices[i] = c * x + s * z;
      paddle.vertices[i + 2] = c * z - s * x;
    }
    parts.push(paddle);
  }
  return join(parts);
}

function cylinder(radius, width, sides = 24) {
  const vertices = [0, -width / 2, 0, 0, width / 2, 0],
    triangles = [];
  for (let k = 0; k < sides; ++k) {
    const turn = (2 * Math.PI * k) / sides;
    for (const y of [-width / 2, width / 2])
      vertices.push(radius * Math.cos(turn), y, radius * Math.sin(turn));
    const a = 2 + 2 * k,
      b = 2 + 2 * ((k + 1) % sides);
    triangles.push(a, b, a + 1, b, b + 1, a + 1, 0, b, a, 1, a + 1, b + 1);
  }
  return { vertices, triangles };
}

function join(parts) {
  const vertices = [],
    triangles = [];
  for (const part of parts) {
    const begin = vertices.length / 3;
    vertices.push(...part.vertices);
    triangles.push(...part.triangles.map((t) => t + begin));
  }
  return { vertices, triangles };
}

/** A grey PNG: ground, sky, and the board's discs. @returns {Uint8Array} */
export function picture(width, height, discs) {
  const rows = Buffer.alloc((width + 1) * height);
  for (let v = 0; v < height; ++v) {
    for (let u = 0; u < width; ++u) {
      let grey = v < height * 0.45 ? 190 - v / 4 : 110 + ((u * 7 + v * 13) % 11);
      for (const [du, dv, radius] of discs) if ((u - du) ** 2 + (v - dv) ** 2 < radius * radius) grey = 30;
      rows[v * (width + 1) + 1 + u] = grey;
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 0, 0, 0, 0], 8);
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
    const [size, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    size.writeUInt32BE(data.length);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([size, body, check]);
  };
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk('IHDR', head),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}
