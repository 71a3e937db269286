// What success depends on: the strength of each draw, and success by its levels.

import * as Plot from './plot.js';
import { card, make } from '../dom.js';
import { fixed, group, interval, number } from '../format.js';

const MOST_DRAWS = 15;
const MOST_LEVELS = 6;
const BARS_WIDTH = 384;
const CHARACTER_WIDTH = 6.1; // of the axis, 10 px high

/** @param {any} header */
export function sensitivity(header) {
  const arms = (header.sensitivity ?? []).filter(
    (/** @type {any} */ arm) => arm.draws.length > 0 || arm.warning,
  );
  if (arms.length === 0) return null;
  return card(
    'sensitivity',
    'What success depends on',
    'Strength 0 to 1: share of the variation of success that goes with a draw, of any shape (eta). ' +
      'p: adjusted for the number of draws by Holm’s method. ' +
      'Direction -1 to 1: rank correlation with its 95 % interval, of draws of numbers.',
    ...arms.map((/** @type {any} */ arm) =>
      make(
        'div',
        null,
        arm.arm && make('h3', null, `Arm ${arm.arm}`),
        ...(hasStrength(arm)
          ? [make('div', { class: 'pair' }, strengths(arm), directions(arm)), levels(arm)]
          : [make('p', null, whyNoStrength(arm))]),
      ),
    ),
  );
}

/** @param {any} arm */
function hasStrength(arm) {
  return arm.draws.some((/** @type {any} */ draw) => typeof draw.eta === 'number');
}

/** @param {any} arm */
function whyNoStrength(arm) {
  return arm.warning
    ? `${arm.warning}.`
    : 'All runs ended alike: success does not vary with any draw.';
}

/** The strongest draws. @param {any} arm */
function strongest(arm) {
  return [...arm.draws].sort((a, b) => (b.eta ?? -1) - (a.eta ?? -1)).slice(0, MOST_DRAWS);
}

/** Room for the longest label. @param {any[]} rows */
function marginFor(rows) {
  return Math.max(120, 16 + CHARACTER_WIDTH * Math.max(...rows.map((r) => r.label.length)));
}

/** @param {any[]} rows */
function frame(rows) {
  return {
    width: 560,
    height: 40 + 22 * rows.length,
    marginTop: 4,
    marginBottom: 34,
    y: { domain: rows.map((r) => r.label), label: null, tickSize: 0, padding: 0.3 },
  };
}

/** @param {any} arm */
function strengths(arm) {
  const rows = strongest(arm);
  const shown = rows.filter((r) => r.eta !== null && !Number.isNaN(r.eta));
  const margin = marginFor(rows);
  const plot = Plot.plot({
    ...frame(rows),
    width: BARS_WIDTH + margin,
    marginLeft: margin,
    marginRight: 136,
    ariaLabel: 'Strength of each draw',
    x: { domain: [0, 1], label: 'strength', ticks: 5 },
    marks: [
      Plot.gridX({ strokeOpacity: 0.12, ticks: 5 }),
      Plot.barX(shown, { x: 'eta', y: 'label', fill: 'var(--success)', fillOpacity: 0.75 }),
      Plot.text(shown, {
        x: 'eta',
        y: 'label',
        textAnchor: 'start',
        dx: 6,
        fill: 'var(--text)',
        text: (/** @type {any} */ r) => `${fixed(r.eta, 2)}${r.p === null ? '' : `  p (Holm) ${number(r.p, 2)}`}`,
      }),
    ],
  });
  const rest = arm.draws.length - rows.length;
  return make(
    'figure',
    null,
    plot,
    rest > 0 && make('p', { class: 'note' }, `${rest} weaker draws are not shown.`),
  );
}

/** @param {any} arm */
function directions(arm) {
  const rows = strongest(arm);
  const shown = rows.filter((r) => r.rank).map((r) => ({ label: r.label, ...r.rank }));
  if (shown.length === 0) return null;
  return make(
    'figure',
    null,
    Plot.plot({
      ...frame(rows),
      width: 340,
      marginLeft: 12,
      marginRight: 12,
      y: { ...frame(rows).y, axis: null },
      ariaLabel: 'Rank correlation of success with each draw',
      x: {
        domain: [-1, 1],
        label: 'fails more often with more  ·  succeeds more often with more',
        labelAnchor: 'center',
        labelArrow: 'none',
        ticks: 5,
      },
      marks: [
        Plot.gridX({ strokeOpacity: 0.12, ticks: 5 }),
        Plot.ruleX([0], { stroke: 'var(--quiet)' }),
        Plot.ruleY(shown, {
          x1: 'low',
          x2: 'high',
          y: 'label',
          stroke: 'var(--success)',
          strokeWidth: 5,
          strokeOpacity: 0.35,
        }),
        Plot.dot(shown, { x: 'value', y: 'label', fill: 'var(--success)', r: 4 }),
      ],
    }),
  );
}

/** @param {any} arm */
function levels(arm) {
  const names = strongest(arm)
    .map((draw) => draw.label)
    .slice(0, MOST_LEVELS);
  const figures = names
    .map((name) => {
      const rows = (arm.levels ?? []).filter((/** @type {any} */ level) => level.label === name);
      return rows.length > 0 ? levelPlot(name, rows) : null;
    })
    .filter(Boolean);
  return figures.length > 0 && make('div', { class: 'multiples' }, figures);
}

/** @param {string} name @param {any[]} rows */
function levelPlot(name, rows) {
  const shown = rows.map((level) => ({
    level: levelName(level),
    share: level.successes / level.runs,
    low: level.interval[0],
    high: level.interval[1],
    text: `${levelName(level)}: ${group(level.successes)} of ${group(level.runs)}, ${interval(level.interval)}`,
  }));
  const every = Math.ceil(shown.length / 5);
  return make(
    'figure',
    null,
    make('figcaption', null, `Success by ${name}`),
    Plot.plot({
      width: 300,
      height: 140,
      marginLeft: 36,
      marginBottom: 26,
      marginTop: 8,
      ariaLabel: `Success by ${name}`,
      x: {
        domain: shown.map((r) => r.level),
        label: null,
        tickSize: 0,
        tickFormat: (/** @type {string} */ text, /** @type {number} */ i) =>
          i % every === 0 ? text.split(' ')[0] : '',
      },
      y: { domain: [0, 1], label: null, ticks: 3, tickFormat: (/** @type {number} */ v) => `${100 * v}` },
      marks: [
        Plot.gridY({ ticks: 3, strokeOpacity: 0.12 }),
        Plot.ruleX(shown, {
          x: 'level',
          y1: 'low',
          y2: 'high',
          stroke: 'var(--success)',
          strokeWidth: 5,
          strokeOpacity: 0.35,
        }),
        Plot.dot(shown, { x: 'level', y: 'share', fill: 'var(--success)', r: 4, title: 'text' }),
      ],
    }),
  );
}

/** @param {any} level */
function levelName(level) {
  if (level.word) return level.word;
  return level.low === level.high
    ? number(level.low, 3)
    : `${number(level.low, 3)} – ${number(level.high, 3)}`;
}
