// Map of the starts in the target's frame: where the runs began, and which succeeded.

import * as Plot from './plot.js';
import { card, make } from '../dom.js';
import { fixed, group } from '../format.js';

export const MOST_POINTS = 2000;

/** A run's place in a sample that follows no pattern of the numbers. @param {number} run */
export function scatter(run) {
  let h = Math.imul(run ^ 0x9e3779b9, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/**
 * @param {import('../table.js').Table} table
 * @param {(run: number) => void} openRun
 */
export function starts(table, openRun) {
  const [x, y, heading] = table.starts;
  if (!x || !y) return null;
  const points = samplePoints(table, x, y, heading);
  if (points.length === 0) return null;
  const thinned =
    points.length < table.rows ? ` A random sample of ${group(points.length)} runs is shown.` : '';
  return card(
    'starts',
    'Starts',
    `Start poses seen from above, in the target's frame: it stands at 0, x points out of it. Click a run to open it.${thinned}`,
    legend(table.word),
    drawMap(points, Boolean(heading), openRun),
  );
}

/** @param {import('../table.js').Table} table @param {any} x @param {any} y @param {any} heading */
function samplePoints(table, x, y, heading) {
  const limit = table.rows > MOST_POINTS ? (MOST_POINTS / table.rows) * 2 ** 32 : 2 ** 32;
  const points = [];
  for (let row = 0; row < table.rows; ++row) {
    const run = table.run.values[row];
    if (scatter(run) >= limit || Number.isNaN(x[row]) || Number.isNaN(y[row])) continue;
    points.push({
      run,
      x: x[row],
      y: y[row],
      heading: heading ? heading[row] : 0,
      success: table.isSuccess(row),
      outcome: table.outcome(row),
    });
  }
  return points;
}

/** @param {string} word */
function legend(word) {
  return make(
    'p',
    { class: 'legend' },
    make('span', { class: 'success' }, `● ${word}`),
    make('span', { class: 'failed' }, '✕ failed'),
    make('span', { class: 'quiet' }, 'the tick is the heading'),
  );
}

const AROUND_M = 0.5; // shown to both sides of the axis where all starts lie on it

/** All on the target's axis, but for rounding: a range of their own would be 0. @param {any[]} points */
function onTheAxis(points) {
  return points.every((p) => Math.abs(p.y) < 1e-3);
}

/** @param {any[]} points @param {boolean} with_heading @param {(run: number) => void} openRun */
function drawMap(points, with_heading, openRun) {
  const successes = points.filter((p) => p.success),
    failed = points.filter((p) => !p.success);
  const small = points.length > 400;
  const tick = (/** @type {string} */ colour) => ({
    x: 'x',
    y: 'y',
    anchor: 'start',
    shape: 'spike',
    r: 1.6,
    rotate: (/** @type {any} */ p) => 90 - p.heading,
    length: small ? 9 : 15,
    stroke: colour,
    fill: colour,
    strokeOpacity: 0.7,
  });
  const plot = Plot.plot({
    width: 620,
    ...boundedHeight(points),
    marginLeft: 44,
    marginBottom: 36,
    marginTop: 24,
    inset: 16,
    ariaLabel: `Map of ${points.length} starts`,
    x: { label: 'x [m]', nice: true },
    y: { label: 'y [m]', nice: true, ...(onTheAxis(points) ? { domain: [-AROUND_M, AROUND_M] } : {}) },
    marks: [
      Plot.gridX({ strokeOpacity: 0.1 }),
      Plot.gridY({ strokeOpacity: 0.1 }),
      Plot.ruleY([0], { stroke: 'var(--quiet)', strokeDasharray: '2,4' }),
      Plot.dot([{ x: 0, y: 0 }], { x: 'x', y: 'y', symbol: 'square', r: 8, fill: 'var(--text)' }),
      Plot.text([{ x: 0, y: 0 }], {
        x: 'x',
        y: 'y',
        text: () => 'target',
        dx: 14,
        dy: -10,
        textAnchor: 'start',
        fill: 'var(--quiet)',
      }),
      with_heading ? Plot.vector(successes, tick('var(--success)')) : null,
      with_heading ? Plot.vector(failed, tick('var(--failed)')) : null,
      Plot.dot(successes, {
        x: 'x',
        y: 'y',
        r: small ? 2.5 : 4,
        fill: 'var(--success)',
        stroke: 'var(--card)',
        strokeWidth: 0.7,
      }),
      Plot.dot(failed, {
        x: 'x',
        y: 'y',
        r: small ? 3 : 5,
        symbol: 'times',
        stroke: 'var(--failed)',
        strokeWidth: 2.2,
      }),
      Plot.tip(
        points,
        Plot.pointer({
          x: 'x',
          y: 'y',
          fill: 'var(--card)',
          title: (/** @type {any} */ p) =>
            `Run ${p.run}: ${p.outcome}\nx ${fixed(p.x, 2)} m, y ${fixed(p.y, 2)} m` +
            (with_heading ? `, heading ${fixed(p.heading, 0)}°` : ''),
        }),
      ),
    ],
  });
  plot.style.cursor = 'pointer';
  plot.addEventListener('click', () => {
    const point = /** @type {any} */ (plot).value;
    if (point) openRun(point.run);
  });
  return make('figure', null, plot);
}

/** Equal scales on both axes, unless that would make the map very flat or very tall. @param {any[]} points */
function boundedHeight(points) {
  const span = (/** @type {'x' | 'y'} */ axis) => {
    const values = points.map((p) => p[axis]);
    return (
      Math.max(
        0,
        values.reduce((a, b) => Math.max(a, b), -Infinity),
      ) -
      Math.min(
        0,
        values.reduce((a, b) => Math.min(a, b), Infinity),
      )
    );
  };
  const ratio = (span('y') || 0.01) / (span('x') || 0.01);
  if (ratio > 1.1) return { height: 620 };
  return ratio < 0.3 ? { height: 260 } : { aspectRatio: 1 };
}
