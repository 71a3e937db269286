// Lines that lie on the ground: the ways that were driven and believed, and the plan.

import { BufferGeometry, Float32BufferAttribute, Line, LineDashedMaterial } from 'three';

/** @typedef {{at: (x: number, y: number) => number}} Ground */

/**
 * The whole way as a line, and how many of its points lie at or before each sample.
 * @param {import('./tracks.js').Tracks} tracks
 * @param {Ground} ground
 * @param {'truth' | 'believed'} which
 * @param {any} material
 * @param {number} above
 */
export function makeTrail(tracks, ground, which, material, above) {
  const line = makeLine(material);
  const { points, samples } = tracks.trail(which, tracks.end_s);
  lay(line, ground, points, above);
  const until = new Uint32Array(tracks.samples);
  for (const sample of samples) ++until[sample];
  for (let k = 1; k < until.length; ++k) until[k] += until[k - 1];
  return { line, until };
}

/**
 * Lays a line on the ground, a little above it.
 * @param {Line} line
 * @param {Ground} ground
 * @param {number[][]} points
 * @param {number} above
 */
export function lay(line, ground, points, above) {
  line.visible = points.length > 1;
  if (!line.visible) return;
  const values = points.flatMap(([x, y]) => [x, y, ground.at(x, y) + above]);
  line.geometry.dispose();
  line.geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(values, 3));
  if (line.material instanceof LineDashedMaterial) line.computeLineDistances();
}

/** @param {any} material */
export function makeLine(material) {
  const line = new Line(new BufferGeometry(), material);
  line.frustumCulled = false;
  line.visible = false;
  return line;
}
