// The limits of the judge: how often each was broken, and its margin against each drawn number.

import * as Plot from './plot.js';
import { card, make, tableHead } from '../dom.js';
import { group, number } from '../format.js';
import { MOST_POINTS, scatter } from './starts.js';

const MOST_DRAWS = 12;

/**
 * @param {any} header
 * @param {import('../table.js').Table} table
 * @param {(run: number) => void} openRun
 */
export function margins(header, table, openRun) {
  /** @type {any[]} */
  const limits = (header.limits ?? []).filter((/** @type {any} */ l) => table.byName.has(`margin.${l.name}`));
  if (table.rows < 2 || limits.length === 0) return null;
  return card(
    'margins',
    'Margins to the limits',
    `What each run was judged by. The least margin is that of the runs ${table.word}; positive is good.`,
    limitTable(limits, openRun),
    againstDraws(header, table, limits, openRun),
  );
}

/** @param {any[]} limits @param {(run: number) => void} openRun */
function limitTable(limits, openRun) {
  const rows = limits.map((l) =>
    make(
      'tr',
      { title: l.meaning },
      make('th', { scope: 'row' }, l.name),
      make('td', null, `${group(l.broken)} of ${group(l.judged)}`),
      make('td', { class: 'value' }, l.run === undefined ? '–' : `${number(l.least, 3)} ${l.unit}`),
      make('td', { class: 'value' }, l.run !== undefined && runButton(l.run, openRun)),
    ),
  );
  return make(
    'table',
    { class: 'plain' },
    tableHead(['Limit', 'Broken', 'Least margin', 'Run'], (name) => (/L.*n|Run/.test(name) ? 'value' : null)),
    make('tbody', null, rows),
  );
}

/** @param {number} run @param {(run: number) => void} openRun */
function runButton(run, openRun) {
  return make(
    'button',
    { class: 'chip', type: 'button', 'aria-label': `Open run ${run}`, onclick: () => openRun(run) },
    String(run),
  );
}

/** A plot for each drawn number, of the limit that is chosen: the first is the tightest.
 * @param {any} header @param {import('../table.js').Table} table @param {any[]} limits
 * @param {(run: number) => void} openRun
 */
function againstDraws(header, table, limits, openRun) {
  const draws = (header.sensitivity?.[0]?.draws ?? [])
    .map((/** @type {any} */ draw) => table.byName.get(draw.label))
    .filter((/** @type {any} */ column) => column && !column.dictionary)
    .slice(0, MOST_DRAWS);
  if (draws.length === 0) return null;
  const figures = make('div', { class: 'multiples' });
  const select = make(
    'select',
    { 'aria-label': 'Limit', onchange: fill },
    limits.map((l) => make('option', { value: l.name }, l.name)),
  );
  function fill() {
    const limit = limits.find((l) => l.name === select.value) ?? limits[0];
    figures.replaceChildren(
      ...draws.map((/** @type {any} */ draw) => marginPlot(table, limit, draw, openRun)),
    );
  }
  fill();
  return make('div', null, make('p', null, 'Margin of ', select, ' against what was drawn'), figures);
}

/** The middle of the values: few runs far out must not squeeze the rest. @param {number[]} values */
function middle(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (/** @type {number} */ share) => sorted[Math.round(share * (sorted.length - 1))];
  const reach = 3 * (at(0.75) - at(0.25));
  const low = Math.min(0, Math.max(at(0), at(0.25) - reach)),
    high = Math.max(0, Math.min(at(1), at(0.75) + reach));
  return high > low ? [low, high] : [low - 1, high + 1];
}

/**
 * @param {import('../table.js').Table} table @param {any} limit
 * @param {import('../table.js').Column} draw @param {(run: number) => void} openRun
 */
function marginPlot(table, limit, draw, openRun) {
  const values = /** @type {any} */ (table.byName.get(`margin.${limit.name}`)).values;
  const most = table.rows > MOST_POINTS ? (MOST_POINTS / table.rows) * 2 ** 32 : 2 ** 32;
  const points = [];
  for (let row = 0; row < table.rows; ++row) {
    const run = table.run.values[row];
    if (scatter(run) >= most || Number.isNaN(values[row]) || Number.isNaN(draw.values[row])) continue;
    points.push({ run, x: draw.values[row], y: values[row], success: table.isSuccess(row) });
  }
  const plot = Plot.plot({
    width: 300,
    height: 150,
    marginLeft: 46,
    marginBottom: 26,
    marginTop: 8,
    ariaLabel: `Margin of ${limit.name} against ${draw.name}`,
    x: { label: null, ticks: 4 },
    y: { label: null, ticks: 4, domain: middle(points.map((p) => p.y)), clamp: true },
    marks: [
      Plot.ruleY([0], { stroke: 'var(--quiet)' }),
      Plot.dot(
        points.filter((p) => p.success),
        { x: 'x', y: 'y', r: 2.5, fill: 'var(--success)' },
      ),
      Plot.dot(
        points.filter((p) => !p.success),
        { x: 'x', y: 'y', r: 3, symbol: 'times', stroke: 'var(--failed)' },
      ),
      Plot.tip(
        points,
        Plot.pointer({
          x: 'x',
          y: 'y',
          fill: 'var(--card)',
          title: (/** @type {any} */ p) => `Run ${p.run}: ${number(p.y)} ${limit.unit} at ${number(p.x)}`,
        }),
      ),
    ],
  });
  plot.style.cursor = 'pointer';
  plot.addEventListener('click', () => {
    const point = /** @type {any} */ (plot).value;
    if (point) openRun(point.run);
  });
  return make('figure', null, make('figcaption', null, `${draw.name}, margin [${limit.unit}]`), plot);
}
