// Histograms of each measure: successes upwards, failed runs downwards.

import * as Plot from './plot.js';
import { card, make } from '../dom.js';
import { axisName, group } from '../format.js';

const BINS = 24;
const SAMPLE = 2000; // values that decide where the bins end

const MEASURED = new Set(['sim_time_s', 'images']);
const PLACES = new Set(['point', 'repeat']); // they number the runs

/** @param {import('../table.js').Table} table */
export function distributions(table) {
  if (table.rows < 2) return null;
  const columns = table
    .measures()
    .filter((column) => !PLACES.has(column.name) && !column.name.startsWith('margin.'));
  const told = columns.some((column) => column.meaning);
  const measured = columns.filter((column) => !told || column.meaning || MEASURED.has(column.name));
  const figures = histograms(table, measured);
  if (figures.length === 0) return null;
  return card(
    'distributions',
    'Distributions',
    'Number of runs by measure: successes upwards, failed runs downwards (hatched).',
    hatch(),
    make('div', { class: 'multiples' }, figures),
    given(
      table,
      columns.filter((column) => !measured.includes(column)),
    ),
  );
}

/**
 * What the runs were given: there may be many, so they are drawn when they are asked for.
 * @param {import('../table.js').Table} table @param {import('../table.js').Column[]} columns
 */
function given(table, columns) {
  if (columns.length === 0) return null;
  const details = make('details', null, make('summary', null, `${columns.length} numbers that the runs were given`));
  details.addEventListener(
    'toggle',
    () => details.append(make('div', { class: 'multiples' }, histograms(table, columns))),
    { once: true },
  );
  return details;
}

/** @param {import('../table.js').Table} table @param {import('../table.js').Column[]} columns */
function histograms(table, columns) {
  return columns
    .map((column) => ({ column, bins: count(table, column) }))
    .filter(({ bins }) => bins !== null)
    .map(({ column, bins }) =>
      make(
        'figure',
        { title: column.meaning },
        make('figcaption', null, axisName(column)),
        histogram(column, /** @type {any} */ (bins)),
      ),
    );
}

/** @param {import('../table.js').Table} table @param {import('../table.js').Column} column */
function count(table, column) {
  const limits = binLimits(column.values);
  if (!limits) return null;
  const [low, high] = limits;
  const success = new Float64Array(BINS),
    failed = new Float64Array(BINS);
  const scale = BINS / (high - low);
  let beyond = 0;
  for (let row = 0; row < table.rows; ++row) {
    const value = column.values[row];
    if (Number.isNaN(value)) continue;
    if (value < low || value > high) ++beyond;
    const bin = Math.min(BINS - 1, Math.max(0, Math.floor((value - low) * scale)));
    if (table.isSuccess(row)) ++success[bin];
    else ++failed[bin];
  }
  return { low, high, success, failed, beyond };
}

/**
 * Where the bins begin and end: few runs far out must not squeeze the rest.
 * @param {any} values
 * @returns {[number, number] | null}
 */
function binLimits(values) {
  const step = Math.max(1, Math.floor(values.length / SAMPLE));
  const some = [];
  for (let i = 0; i < values.length; i += step) if (Number.isFinite(values[i])) some.push(values[i]);
  if (some.length < 2) return null;
  some.sort((a, b) => a - b);
  const cut = some.length > 200 ? 0.002 : 0;
  const low = some[Math.floor(cut * (some.length - 1))],
    high = some[Math.ceil((1 - cut) * (some.length - 1))];
  return high > low ? [low, high] : null;
}

/** @param {import('../table.js').Column} column @param {any} bins */
function histogram(column, bins) {
  const width = (bins.high - bins.low) / BINS;
  const rows = Array.from({ length: BINS }, (_, i) => ({
    from: bins.low + i * width,
    to: bins.low + (i + 1) * width,
    success: bins.success[i],
    failed: -bins.failed[i],
  }));
  const plot = Plot.plot({
    width: 300,
    height: 130,
    marginLeft: 40,
    marginRight: 12,
    marginTop: 6,
    marginBottom: 22,
    ariaLabel: `Histogram of ${axisName(column)}`,
    x: { label: null, ticks: 3 },
    y: {
      label: null,
      ticks: 4,
      tickSize: 0,
      tickFormat: (/** @type {number} */ v) => (Number.isInteger(v) ? short(Math.abs(v)) : ''),
    },
    marks: [
      Plot.rectY(rows, {
        x1: 'from',
        x2: 'to',
        y: 'success',
        fill: 'var(--success)',
        fillOpacity: 0.8,
        inset: 0.5,
      }),
      Plot.rectY(rows, {
        x1: 'from',
        x2: 'to',
        y: 'failed',
        fill: 'url(#hatch)',
        stroke: 'var(--failed)',
        inset: 0.5,
      }),
      Plot.ruleY([0], { stroke: 'var(--quiet)' }),
    ],
  });
  const note =
    bins.beyond > 0 ? make('div', { class: 'note' }, `${group(bins.beyond)} beyond, in the end bars`) : null;
  return make('div', null, plot, note);
}

/** @param {number} count */
function short(count) {
  return count >= 1000 ? `${count / 1000}k` : String(count);
}

/** The pattern of the failed runs' bars. */
function hatch() {
  const holder = make('div', { class: 'hatch', 'aria-hidden': 'true' });
  const name = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(name, 'svg'),
    pattern = document.createElementNS(name, 'pattern');
  const ground = document.createElementNS(name, 'rect'),
    line = document.createElementNS(name, 'path');
  for (const [key, value] of Object.entries({
    id: 'hatch',
    width: 5,
    height: 5,
    patternUnits: 'userSpaceOnUse',
  })) {
    pattern.setAttribute(key, String(value));
  }
  for (const [key, value] of Object.entries({ width: 5, height: 5, class: 'hatch-ground' })) {
    ground.setAttribute(key, String(value));
  }
  line.setAttribute('d', 'M0 5 L5 0 M-1 1 L1 -1 M4 6 L6 4');
  line.setAttribute('class', 'hatch-line');
  pattern.append(ground, line);
  svg.append(pattern);
  svg.setAttribute('width', '0');
  svg.setAttribute('height', '0');
  holder.append(svg);
  return holder;
}
