// Results over a factor that is a number: success with its exact intervals, measures with their spread.
// All intervals come with the data.

import * as Plot from './plot.js';
import { card, make } from '../dom.js';
import { axisName, group, number, percent, setting } from '../format.js';
import { aims } from './success.js';

const SYMBOLS = ['circle', 'square', 'triangle', 'diamond', 'star', 'wye'];
const SIGNS = ['●', '■', '▲', '◆', '★', 'Y'];
const APART = 5; // px between the intervals of two curves at one value
const MOST_TICKS = 8;

/** @param {any} header @param {import('../table.js').Table} table */
export function curves(header, table) {
  const figures = header.curves ?? [];
  if (figures.length === 0) return null;
  const measures = figures.some((/** @type {any} */ f) => f.measure !== 'success');
  return card(
    'curves',
    'Curves of the design',
    'Success: share of runs that succeeded, with its exact 95 % interval.' +
      (measures ? ' Measures: median, and where 10 to 90 % of the runs lie.' : ''),
    make(
      'div',
      { class: 'curves' },
      figures.map((/** @type {any} */ f) => curveFigure(f, header, table)),
    ),
  );
}

/** @param {any} f @param {any} header @param {import('../table.js').Table} table */
function curveFigure(f, header, table) {
  const success = f.measure === 'success';
  const x_name = axisName({ name: f.x, unit: table.byName.get(f.x)?.unit ?? /_(deg|m|s|kg)$/.exec(f.x)?.[1] });
  const y_name = success ? 'Success' : axisName({ name: f.measure, unit: f.unit });
  const rows = f.curves.flatMap((/** @type {any} */ curve, /** @type {number} */ i) =>
    curve.points.map((/** @type {any} */ p) => ({ ...p, i, text: pointText(f, curve, p, success) })),
  );
  const title = `${y_name} over ${x_name}${f.where ? `, ${f.where}` : ''}`;
  return make(
    'figure',
    null,
    make('figcaption', null, title),
    legend(f),
    Plot.plot({
      width: 480,
      height: 250,
      marginLeft: 52,
      marginRight: 14,
      marginTop: 18,
      marginBottom: 38,
      inset: 8,
      ariaLabel: title,
      x: { label: x_name, labelAnchor: 'center', labelArrow: 'none', ...ticksAt(rows), inset: 14 },
      y: success
        ? {
            domain: [0, 1],
            label: null,
            ticks: 5,
            tickFormat: (/** @type {number} */ v) => `${Math.round(100 * v)} %`,
          }
        : { label: null, ticks: 5, nice: true },
      marks: [
        Plot.gridY({ ticks: 5, strokeOpacity: 0.12 }),
        ...(success ? aimMarks(header) : []),
        ...f.curves.flatMap((/** @type {any} */ _, /** @type {number} */ i) =>
          curveMarks(
            rows.filter((/** @type {any} */ r) => r.i === i),
            i,
            APART * (i - (f.curves.length - 1) / 2),
          ),
        ),
      ],
    }),
  );
}

/** @param {any[]} points @param {number} i @param {number} dx */
function curveMarks(points, i, dx) {
  const colour = `var(--curve${i % SYMBOLS.length})`;
  return [
    Plot.line(points, { x: 'x', y: 'value', stroke: colour, strokeWidth: 1.5, strokeOpacity: 0.7, dx }),
    Plot.ruleX(points, { x: 'x', y1: 'low', y2: 'high', stroke: colour, strokeWidth: 3, strokeOpacity: 0.45, dx }),
    Plot.dot(points, {
      x: 'x',
      y: 'value',
      r: 4,
      symbol: /** @type {any} */ (SYMBOLS[i % SYMBOLS.length]),
      fill: colour,
      title: 'text',
      dx,
    }),
  ];
}

/** A line at each limit, named above its right end. @param {any} header */
function aimMarks(header) {
  const list = aims(header);
  if (list.length === 0) return [];
  return [
    Plot.ruleY(list, { y: 'share', stroke: 'var(--plan)', strokeWidth: 1.5, strokeDasharray: '6,3' }),
    Plot.text(list, {
      y: 'share',
      frameAnchor: 'right',
      textAnchor: 'end',
      lineAnchor: 'bottom',
      dy: -3,
      fill: 'var(--plan)',
      text: (/** @type {any} */ aim) => `aim: ${aim.text}`,
    }),
  ];
}

/** The values themselves, if they are few. @param {any[]} rows */
function ticksAt(rows) {
  const values = [...new Set(rows.map((r) => r.x))];
  return values.length <= MOST_TICKS ? { ticks: values, tickFormat: (/** @type {number} */ v) => number(v) } : { ticks: 6 };
}

/** @param {any} f */
function legend(f) {
  if (!f.by) return null;
  return make(
    'p',
    { class: 'legend' },
    make('span', { class: 'quiet' }, f.by),
    f.curves.map((/** @type {any} */ curve, /** @type {number} */ i) =>
      make(
        'span',
        null,
        make('span', { style: `color:var(--curve${i % SIGNS.length})`, 'aria-hidden': 'true' }, SIGNS[i % SIGNS.length]),
        ` ${setting(curve.name)}`,
      ),
    ),
  );
}

/** @param {any} f @param {any} curve @param {any} p @param {boolean} success */
function pointText(f, curve, p, success) {
  const where = `${f.x} ${number(p.x)}${f.by ? `, ${setting(curve.name)}` : ''}`;
  const value = success
    ? `${percent(p.value, p.runs)} % (${percent(p.low, p.runs)} to ${percent(p.high, p.runs)}) of ${group(p.runs)} runs`
    : `${number(p.value)} (${number(p.low)} to ${number(p.high)}), ${group(p.runs)} runs`;
  return `${where}: ${value}`;
}
