// Success with its exact intervals, over all runs and by every factor. All intervals come with the data.

import * as Plot from './plot.js';
import { card, make, oneStop } from '../dom.js';
import { group, interval, percent, setting } from '../format.js';

const MARGIN_LEFT = 150;
const MARGIN_RIGHT = 150;

/** @param {any} header */
export function headline(header) {
  const { runs, successes, word, interval: limits, planned, lost } = header.totals;
  const share = runs > 0 ? successes / runs : NaN;
  const notes = [];
  if (planned > runs) notes.push(`${group(planned - runs)} of ${group(planned)} planned runs are missing.`);
  if (lost > 0) notes.push(`${group(lost)} runs were lost and count as failures.`);
  return card(
    'success',
    'Success',
    null,
    make(
      'p',
      { class: 'headline' },
      make('span', { class: 'big' }, `${percent(share, runs)} %`),
      make(
        'span',
        null,
        `${group(successes)} of ${group(runs)} runs ${word}`,
        limits && make('br'),
        limits && `95 % interval ${interval(limits, runs)}`,
      ),
    ),
    limits && intervalBar(share, limits),
    notes.length > 0 && make('p', { class: 'note' }, notes.join(' ')),
  );
}

/** @param {number} share @param {[number, number]} limits */
function intervalBar(share, limits) {
  const at = (/** @type {number} */ x) => `${(100 * x).toFixed(2)}%`;
  return make(
    'div',
    {
      class: 'interval-bar',
      role: 'img',
      'aria-label': `${percent(share)} %, 95 % interval ${interval(limits)}`,
    },
    make('div', { class: 'range', style: `left:${at(limits[0])};width:${at(limits[1] - limits[0])}` }),
    make('div', { class: 'mark', style: `left:${at(share)}` }),
  );
}

/**
 * @param {any} header
 * @param {import('../table.js').Table} table
 * @param {(filter: string) => void} showFilter
 */
export function factors(header, table, showFilter) {
  const groups = (header.groups ?? []).filter((/** @type {any} */ g) => g.values.length > 0);
  if (groups.length === 0) return null;
  return card(
    'factors',
    'Success by factor',
    `Share of runs that succeeded, with its exact 95 % interval. The broken line marks all runs${aims(header).length > 0 ? ', the green line the aim' : ''}.`,
    ...groups.map((/** @type {any} */ g) =>
      factor(g, header, table.byName.has(g.label) ? showFilter : null),
    ),
  );
}

/** Limits that success is held against: `{text, share}`. @param {any} header @returns {any[]} */
export function aims(header) {
  return header.aims ?? [];
}

/** @param {any} factor_group @param {any} header @param {((filter: string) => void) | null} showFilter */
function factor(factor_group, header, showFilter) {
  const { totals } = header;
  const rows = factor_group.values.map((/** @type {any} */ v) => ({
    value: String(v.value),
    name: shorten(setting(String(v.value))),
    share: v.runs > 0 ? v.successes / v.runs : NaN,
    low: v.interval?.[0],
    high: v.interval?.[1],
    text: `${group(v.successes)}/${group(v.runs)}`,
    range: interval(v.interval, v.runs),
  }));
  const plot = Plot.plot({
    width: 620,
    height: 30 + 22 * rows.length,
    marginLeft: MARGIN_LEFT,
    marginRight: MARGIN_RIGHT,
    marginTop: 4,
    marginBottom: 26,
    ariaLabel: `Success by ${factor_group.label}`,
    x: {
      domain: [0, 1],
      tickFormat: (/** @type {number} */ v) => `${Math.round(100 * v)}`,
      label: null,
      ticks: 5,
    },
    y: {
      domain: rows.map((/** @type {any} */ r) => r.value),
      label: null,
      padding: 0.3,
      tickSize: 0,
      tickFormat: (/** @type {string} */ value) => shorten(setting(value)),
    },
    marks: [
      Plot.gridX({ ticks: 5, strokeOpacity: 0.12 }),
      Plot.ruleX([totals.successes / totals.runs], { stroke: 'var(--quiet)', strokeDasharray: '3,3' }),
      Plot.ruleX(
        aims(header).map((aim) => aim.share),
        { stroke: 'var(--plan)', strokeWidth: 1.5 },
      ),
      Plot.ruleY(
        rows.filter((/** @type {any} */ r) => r.low !== undefined),
        { x1: 'low', x2: 'high', y: 'value', stroke: 'var(--success)', strokeWidth: 5, strokeOpacity: 0.35 },
      ),
      Plot.dot(rows, { x: 'share', y: 'value', r: 4.5, fill: 'var(--success)' }),
      Plot.text(rows, {
        x: 1,
        y: 'value',
        text: (/** @type {any} */ r) => `${r.text}  ${r.range}`,
        textAnchor: 'start',
        dx: 10,
        fill: 'var(--text)',
        fontVariant: 'tabular-nums',
      }),
    ],
  });
  const buttons = !showFilter
    ? []
    : rows.slice(0, 12).map((/** @type {any} */ r) =>
        make(
          'button',
          {
            class: 'link',
            type: 'button',
            onclick: () => showFilter(`${factor_group.label}="${r.value}"`),
          },
          r.name,
        ),
      );
  return make(
    'figure',
    null,
    make('figcaption', null, factor_group.label),
    plot,
    buttons.length > 0 && oneStop(make('p', { class: 'row-links no-print' }, 'Runs with: ', ...buttons)),
  );
}

/** @param {string} text */
function shorten(text) {
  return text.length > 22 ? `${text.slice(0, 21)}…` : text;
}
