// How the table of runs lays out its columns.

import { plainName } from './format.js';

/**
 * Run, outcome, then the rest; `success` says no more than the sign before the outcome.
 * @param {import('./table.js').Table} table
 */
export function inOrder(table) {
  const front = [table.run, table.outcomes, table.byName.get('replay')].filter((c) => c !== undefined);
  return [...front, ...table.columns.filter((c) => !front.includes(c) && c !== table.success)];
}

/** @param {import('./table.js').Table} table @param {import('./table.js').Column} column */
export function columnWidth(table, column) {
  const head = plainName(column.name, column.unit).length + (column.unit ? column.unit.length + 1 : 0);
  let widest = 0;
  if (column.dictionary) widest = Math.max(...column.dictionary.map((text) => text.length)) + 2;
  else
    for (let i = 0; i < Math.min(50, table.rows); ++i)
      widest = Math.max(widest, table.text(column, i).length);
  return Math.round(Math.min(260, Math.max(58, Math.max(head * 6.9 + 22, widest * 7.4 + 18))));
}

/** @param {import('./table.js').Table} table */
export function filterExample(table) {
  const measure = table.measures().find((c) => c.unit === 'm') ?? table.measures()[0];
  const outcome = table.outcomes?.dictionary?.find((_, i) => i > 0) ?? 'timeout';
  return `outcome=${outcome}${measure ? ` ${measure.name}<0.2` : ''}`;
}
