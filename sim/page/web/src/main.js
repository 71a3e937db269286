// Starts the page: unpacks the data, builds the overview, opens runs.

import { make } from './dom.js';
import { overview, pageHead, skipLink } from './overview.js';
import { readPayload } from './payload.js';
import { RunPanel } from './run_panel.js';
import { RunsTable } from './runs_table.js';
import { Table } from './table.js';

/** @type {any} */
const report = { ready: false };
/** @type {any} */ (window).report = report;

async function start() {
  const element = document.getElementById('data');
  const text = element?.textContent ?? '';
  element?.remove(); // saves the memory of its copy
  const payload = await readPayload(text);
  show(payload);
}

/** @param {import('./payload.js').Payload} payload */
function show({ header, blobs }) {
  const table = new Table(header, blobs);
  document.title = header.title ?? 'Report';
  const openRun = (/** @type {number} */ run) => {
    location.hash = `run=${run}`;
  };
  const runs = new RunsTable(table, openRun);
  const panel = new RunPanel(header, blobs, table, runs);
  const head = pageHead(header);
  if (table.rows > 1) head.prepend(skipLink(runs));
  const main = overview(header, table, runs, openRun);
  document.body.replaceChildren(head, main, panel.element);
  let scrolled_to = 0;

  const follow = () => {
    const match = /^#run=(\d+)$/.exec(location.hash);
    const row = match ? table.rowOf(Number(match[1])) : -1;
    if (row >= 0) {
      if (!main.hidden) scrolled_to = window.scrollY;
      main.hidden = head.hidden = true;
      panel.open(row);
      window.scrollTo(0, 0);
    } else {
      panel.close();
      main.hidden = head.hidden = false;
      window.scrollTo(0, scrolled_to);
    }
  };
  window.addEventListener('hashchange', follow);
  if (!header.campaign && table.rows === 1 && !location.hash) {
    history.replaceState(null, '', `#run=${table.run.values[0]}`);
  }
  follow();
  Object.assign(report, {
    totals: header.totals,
    header,
    rows: table.rows,
    successes: table.success_count,
    openRun,
    sort: (/** @type {string} */ name, /** @type {boolean} */ falling) => runs.sort(name, falling),
    filter: (/** @type {string} */ text_of) => runs.filter(text_of),
    shown: () => runs.rows,
    column: (/** @type {string} */ name) => table.byName.get(name)?.values,
    text: (/** @type {string} */ name, /** @type {number} */ row) =>
      table.text(/** @type {any} */ (table.byName.get(name)), row),
    frame: () => panel.frame(),
    ready_ms: performance.now(),
    ready: true,
  });
}

/** @param {unknown} problem */
function refuse(problem) {
  const reason = problem instanceof Error ? problem.message : String(problem);
  report.problem = reason;
  document.body.replaceChildren(
    make(
      'main',
      { class: 'refusal', role: 'alert' },
      make('h1', null, 'This report cannot be shown'),
      make(
        'p',
        null,
        `The file is damaged or incomplete: ${reason}. Make the report again, or copy the file again.`,
      ),
    ),
  );
}

if (!('DecompressionStream' in window)) refuse(new Error('this browser is too old to unpack the data'));
else start().catch(refuse);
