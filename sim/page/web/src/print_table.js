// The failed runs as a plain table, for paper.

import { card, make, tableHead } from './dom.js';
import { axisName } from './format.js';

/** Shown on paper in place of the table: the first failed runs. @param {import('./table.js').Table} table */
export function failuresForPrint(table) {
  const rows = [];
  for (let row = 0; row < table.rows && rows.length < 100; ++row) if (!table.isSuccess(row)) rows.push(row);
  if (rows.length === 0) return null;
  const texts = table.columns
    .filter((c) => c.dictionary && c !== table.outcomes && c.name !== 'replay')
    .slice(0, 5);
  const columns = [table.run, table.outcomes, ...texts, ...table.measures().slice(0, 5)];
  return card(
    'failures',
    'Failed runs',
    rows.length === 100 ? 'The first 100.' : null,
    make(
      'table',
      { class: 'plain' },
      tableHead(columns.map(axisName)),
      make(
        'tbody',
        null,
        rows.map((row) =>
          make(
            'tr',
            null,
            columns.map((c) => make('td', null, table.text(c, row))),
          ),
        ),
      ),
    ),
  );
}
