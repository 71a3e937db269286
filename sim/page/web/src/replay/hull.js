// The convex outline of points in the plane (Andrew 1979).

import { turned } from './poses.js';

/** @param {number[][]} points @returns {number[][]} */
export function convexHull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return [...half(sorted), ...half(sorted.reverse())];
}

/** @param {number[][]} points */
function half(points) {
  /** @type {number[][]} */
  const kept = [];
  for (const p of points) {
    while (kept.length >= 2 && turn(kept[kept.length - 2], kept[kept.length - 1], p) <= 0) kept.pop();
    kept.push(p);
  }
  return kept.slice(0, -1);
}

/** @param {number[]} a @param {number[]} b @param {number[]} c */
function turn(a, b, c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/**
 * The corners of each part's box, in the body's frame.
 * @param {any} body
 * @param {any[]} meshes
 * @param {import('../payload.js').Blobs} blobs
 */
export function bodyCorners(body, meshes, blobs) {
  return (body.parts ?? []).map((/** @type {any} */ part) => {
    const vertices = blobs.f32(meshes[part.mesh].vertices);
    const low = [Infinity, Infinity, Infinity],
      high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < vertices.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], vertices[i]);
      high[i % 3] = Math.max(high[i % 3], vertices[i]);
    }
    const ends = [low, high];
    const corners = Array.from({ length: 8 }, (_, i) => [
      ends[i & 1][0],
      ends[(i >> 1) & 1][1],
      ends[i >> 2][2],
    ]);
    const shift = part.position ?? [0, 0, 0];
    return corners.map((p) => turned(part.quaternion ?? [0, 0, 0, 1], p).map((v, axis) => v + shift[axis]));
  });
}
