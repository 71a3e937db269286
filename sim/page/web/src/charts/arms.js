// Arms compared in pairs, and the verdict of an acceptance test.

import * as Plot from './plot.js';
import { card, make, tableHead } from '../dom.js';
import { fixed, group, number, percent } from '../format.js';

/** @param {any} header */
export function arms(header) {
  const pairs = header.arms ?? [];
  if (pairs.length === 0) return null;
  const rows = pairs.map((/** @type {any} */ p) => ({
    ...p,
    name: `${p.a} against ${p.b}`,
    low: p.interval[0],
    high: p.interval[1],
  }));
  return card(
    'arms',
    'Arms compared',
    'Same start, same draws in both arms. Difference of the shares that succeeded, in percent points, with its 95 % interval.',
    make(
      'figure',
      null,
      Plot.plot({
        width: 620,
        height: 46 + 24 * rows.length,
        marginLeft: 220,
        marginRight: 20,
        marginTop: 4,
        marginBottom: 34,
        ariaLabel: 'Differences between arms',
        x: {
          label: 'second docks more often  ·  first docks more often',
          labelAnchor: 'center',
          labelArrow: 'none',
          tickFormat: (/** @type {number} */ v) => fixed(100 * v, 0),
          ticks: 6,
        },
        y: { domain: rows.map((/** @type {any} */ r) => r.name), label: null, tickSize: 0 },
        marks: [
          Plot.gridX({ strokeOpacity: 0.12 }),
          Plot.ruleX([0], { stroke: 'var(--quiet)' }),
          Plot.ruleY(rows, {
            x1: 'low',
            x2: 'high',
            y: 'name',
            stroke: 'var(--success)',
            strokeWidth: 5,
            strokeOpacity: 0.35,
          }),
          Plot.dot(rows, { x: 'difference', y: 'name', fill: 'var(--success)', r: 4.5 }),
        ],
      }),
    ),
    make('div', { class: 'scroll' }, make(
      'table',
      { class: 'plain' },
      tableHead(['Arms', 'Both', 'Only first', 'Only second', 'Neither', 'Difference', 'Exact p', 'Mid-p']),
      make(
        'tbody',
        null,
        rows.map((/** @type {any} */ r) =>
          make(
            'tr',
            null,
            make('th', { scope: 'row' }, r.name),
            ...[r.both, r.only_a, r.only_b, r.neither].map((n) => make('td', null, group(n))),
            make(
              'td',
              null,
              `${fixed(100 * r.difference, 1)} (${fixed(100 * r.low, 1)} to ${fixed(100 * r.high, 1)})`,
            ),
            make('td', null, number(r.exact_p, 2)),
            make('td', null, number(r.mid_p, 2)),
          ),
        ),
      ),
    )),
  );
}

/** @param {any} header */
export function acceptance(header) {
  const result = header.acceptance;
  if (!result) return null;
  const rows = [
    [
      'To be shown',
      result.reliability &&
        `${percent(result.reliability)} % at a confidence of ${percent(result.confidence)} %`,
    ],
    ['Lower bound', result.lower !== null && result.lower !== undefined && `${percent(result.lower)} %`],
    ['Upper bound', result.upper !== null && result.upper !== undefined && `${percent(result.upper)} %`],
    ['Further runs without a failure', result.further_runs ? group(result.further_runs) : false],
  ].filter(([, text]) => text);
  return card(
    'acceptance',
    'Acceptance',
    null,
    make('p', { class: 'verdict' }, result.verdict),
    make('p', null, result.sentence),
    make(
      'dl',
      { class: 'facts' },
      rows.flatMap(([name, text]) => [make('dt', null, name), make('dd', null, text)]),
    ),
  );
}
