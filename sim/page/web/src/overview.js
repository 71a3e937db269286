// The overview: all sections of a campaign, each only if its data is there.

import { arms, acceptance } from './charts/arms.js';
import { causes } from './charts/causes.js';
import { curves } from './charts/curves.js';
import { distributions } from './charts/distributions.js';
import { extremes } from './charts/extremes.js';
import { margins } from './charts/margins.js';
import { sensitivity } from './charts/sensitivity.js';
import { starts } from './charts/starts.js';
import { factors, headline } from './charts/success.js';
import { card, make } from './dom.js';
import { group } from './format.js';
import { failuresForPrint } from './print_table.js';

/**
 * @param {any} header
 * @param {import('./table.js').Table} table
 * @param {import('./runs_table.js').RunsTable} runs
 * @param {(run: number) => void} openRun
 */
export function overview(header, table, runs, openRun) {
  /** @param {string} filter */
  const showFilter = (filter) => {
    runs.filter(filter);
    runs.element.scrollIntoView({ block: 'start' });
    runs.window.focus({ preventScroll: true });
  };
  const print_table = failuresForPrint(table);
  print_table?.classList.add('print-only');
  return make(
    'main',
    { id: 'overview' },
    make(
      'div',
      { class: 'columns' },
      make(
        'div',
        { class: 'column' },
        headline(header),
        acceptance(header),
        requirements(header),
        factors(header, table, showFilter),
      ),
      make('div', { class: 'column' }, causes(header, openRun, showFilter), starts(table, openRun)),
    ),
    curves(header, table),
    arms(header),
    runs.element,
    margins(header, table, openRun),
    sensitivity(header),
    distributions(table),
    extremes(header, table, openRun),
    print_table,
    leftOut(header),
  );
}

/**
 * A card with a list; null without items.
 * @param {string} id @param {string} title @param {Record<string, string> | null} attributes of the list
 * @param {HTMLElement[]} items
 */
function listCard(id, title, attributes, items) {
  return items.length === 0 ? null : card(id, title, null, make('ul', attributes, items));
}

/** What became of the requirements on the results. @param {any} header */
function requirements(header) {
  const items = (header.requirements ?? []).map((/** @type {any} */ each) =>
    make('li', { class: each.met ? 'success' : 'failed' }, `${each.met ? '●' : '✕'} ${each.text}`),
  );
  return listCard('requirements', 'Requirements', { class: 'requirements' }, items);
}

/** @param {any} header */
function leftOut(header) {
  const items = (header.left_out ?? []).map((/** @type {string} */ text) => make('li', null, text));
  return listCard('left-out', 'Left out', null, items);
}

/** A first stop of the Tab key that leads past all figures. @param {import('./runs_table.js').RunsTable} runs */
export function skipLink(runs) {
  return make(
    'button',
    {
      type: 'button',
      class: 'skip no-print',
      onclick: () => {
        runs.element.scrollIntoView({ block: 'start' });
        runs.window.focus({ preventScroll: true });
      },
    },
    'To the table of runs',
  );
}

/** The head of the page. @param {any} header */
export function pageHead(header) {
  const campaign = header.campaign;
  const facts = campaign
    ? [
        ['Campaign', campaign.name],
        ['System', header.system?.name],
        ['Design', campaign.design],
        ['Seed', campaign.seed],
        ['Runs', group(header.totals.runs)],
        ['File', campaign.file],
      ]
    : [['System', header.system?.name]];
  return make(
    'header',
    { class: 'page-head' },
    make('h1', null, header.title ?? 'Report'),
    make(
      'dl',
      null,
      [...facts, ['Program', header.program]]
        .filter(([, text]) => text)
        .flatMap(([name, text]) => [
          make('div', null, make('dt', null, name), make('dd', null, String(text))),
        ]),
    ),
  );
}
