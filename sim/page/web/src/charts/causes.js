// Failures by cause.

import { card, make, oneStop, tableHead } from '../dom.js';
import { group } from '../format.js';

/**
 * @param {any} header
 * @param {(run: number) => void} openRun
 * @param {(filter: string) => void} showFilter
 */
export function causes(header, openRun, showFilter) {
  const list = header.causes ?? [];
  if (list.length === 0) return card('causes', 'Failures', null, make('p', null, 'No run failed.'));
  const meanings = new Map(
    (header.system?.outcomes ?? []).map((/** @type {any} */ o) => [o.name, o.meaning]),
  );
  const most = Math.max(...list.map((/** @type {any} */ cause) => cause.count));
  const failed = list.reduce((/** @type {number} */ sum, /** @type {any} */ cause) => sum + cause.count, 0);
  return card(
    'causes',
    'Failures by cause',
    `${group(failed)} of ${group(header.totals.runs)} runs failed.`,
    make(
      'table',
      { class: 'causes' },
      tableHead(['Cause', 'Runs', 'Open']),
      make(
        'tbody',
        null,
        list.map((/** @type {any} */ cause) =>
          make(
            'tr',
            null,
            make(
              'th',
              { scope: 'row' },
              make(
                'button',
                {
                  class: 'link failed',
                  type: 'button',
                  onclick: () => showFilter(`outcome=${cause.outcome}`),
                  'aria-label': `Show the runs with ${cause.outcome} in the table`,
                },
                `✕ ${cause.outcome}`,
              ),
              meanings.get(cause.outcome) && make('div', { class: 'note' }, meanings.get(cause.outcome)),
            ),
            make(
              'td',
              { class: 'count' },
              make('div', { class: 'bar', style: `width:${(70 * cause.count) / most}%` }),
              make('span', null, group(cause.count)),
            ),
            oneStop(make(
              'td',
              { class: 'run-links' },
              (cause.runs ?? []).slice(0, 6).map((/** @type {number} */ run) =>
                make(
                  'button',
                  {
                    class: 'chip',
                    type: 'button',
                    onclick: () => openRun(run),
                    'aria-label': `Open run ${run}`,
                  },
                  String(run),
                ),
              ),
              cause.count > Math.min(6, (cause.runs ?? []).length) && make('span', { class: 'quiet' }, '…'),
            )),
          ),
        ),
      ),
    ),
  );
}
