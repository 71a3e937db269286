// The slowest runs, and the runs with the largest value of a measure.

import { card, make, oneStop, outcomeMark, tableHead } from '../dom.js';
import { axisName } from '../format.js';

const SHOWN = 8;

/**
 * @param {any} header
 * @param {import('../table.js').Table} table
 * @param {(run: number) => void} openRun
 */
export function extremes(header, table, openRun) {
  const speeds = ['cpu_time_s', 'wall_time_s']
    .map((name) => table.byName.get(name))
    .filter((c) => c !== undefined);
  const measures = table.measures();
  if (table.rows < 2 || speeds.length + measures.length === 0) return null;
  const choices = [...speeds, ...measures];
  const wanted = (header.worst ?? [])
    .map((/** @type {any} */ w) => ({ ...w, column: w.column.replace(/_rad$/, '_deg') }))
    .filter((/** @type {any} */ w) => table.byName.has(w.column));
  const lists = [];
  if (speeds.length > 0) lists.push(chooser(table, choices, speeds[0].name, true, openRun));
  for (const w of wanted.slice(0, 3))
    lists.push(chooser(table, choices, w.column, w.largest !== false, openRun));
  if (wanted.length === 0 && measures.length > 0)
    lists.push(chooser(table, choices, measures[0].name, true, openRun));
  return card('extremes', 'Slowest and worst runs', null, make('div', { class: 'pair' }, lists));
}

/**
 * A list with its column and direction to choose.
 * @param {import('../table.js').Table} table
 * @param {import('../table.js').Column[]} columns
 * @param {string} name
 * @param {boolean} largest
 * @param {(run: number) => void} openRun
 */
function chooser(table, columns, name, largest, openRun) {
  const body = make('tbody');
  const select = make(
    'select',
    { 'aria-label': 'Measure', onchange: fill },
    columns.map((c) => make('option', { value: c.name, selected: c.name === name }, axisName(c))),
  );
  const direction = make(
    'select',
    { 'aria-label': 'Order', onchange: fill },
    make('option', { value: 'largest', selected: largest }, 'largest'),
    make('option', { value: 'smallest', selected: !largest }, 'smallest'),
  );
  function fill() {
    const column = table.byName.get(select.value);
    if (!column) return;
    body.replaceChildren(
      ...extremeRows(table, column, direction.value === 'largest').map((row) => {
        const run = table.run.values[row];
        return make(
          'tr',
          null,
          make(
            'td',
            null,
            make(
              'button',
              { class: 'chip', type: 'button', 'aria-label': `Open run ${run}`, onclick: () => openRun(run) },
              String(run),
            ),
          ),
          make('td', null, outcomeMark(table.outcome(row), table.isSuccess(row))),
          make('td', { class: 'value' }, table.text(column, row)),
        );
      }),
    );
    for (const [i, button] of body.querySelectorAll('button').entries()) button.tabIndex = i === 0 ? 0 : -1;
  }
  fill();
  oneStop(body);
  return make(
    'div',
    { class: 'extreme' },
    make('p', null, direction, ' ', select),
    make(
      'table',
      { class: 'plain' },
      tableHead(['Run', 'Outcome', 'Value'], (name) => name.toLowerCase()),
      body,
    ),
  );
}

/**
 * @param {import('../table.js').Table} table
 * @param {import('../table.js').Column} column
 * @param {boolean} largest
 */
function extremeRows(table, column, largest) {
  const values = column.values;
  const better = largest
    ? (/** @type {number} */ a, /** @type {number} */ b) => a > b
    : (/** @type {number} */ a, /** @type {number} */ b) => a < b;
  /** @type {number[]} */
  const best = [];
  for (let row = 0; row < table.rows; ++row) {
    if (Number.isNaN(values[row])) continue;
    if (best.length === SHOWN && !better(values[row], values[best[SHOWN - 1]])) continue;
    let place = best.length;
    while (place > 0 && better(values[row], values[best[place - 1]])) --place;
    best.splice(place, 0, row);
    if (best.length > SHOWN) best.pop();
  }
  return best;
}
