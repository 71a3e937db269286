// The table of runs: a few recycled rows in a window that scrolls over all of them.

import { card, make, oneStop } from './dom.js';
import { filterRows } from './filter.js';
import { group, plainName } from './format.js';
import { allRows, sortRows } from './order.js';
import { columnWidth, filterExample, inOrder } from './runs_columns.js';

const ROWS = 24;
const ROW_HEIGHT = 26;
const TALLEST = 8e6; // px; browsers cut taller elements

export class RunsTable {
  /**
   * @param {import('./table.js').Table} table
   * @param {(run: number) => void} openRun
   */
  constructor(table, openRun) {
    this.table = table;
    this.openRun = openRun;
    this.columns = inOrder(table);
    this.found = allRows(table.rows); // the rows that pass the filter, rising
    this.rows = this.found; // in the order that is shown
    /** @type {import('./table.js').Column | null} */
    this.sorted_by = null;
    this.falling = false;
    this.current = 0;
    this.first = 0;
    this.element = this.build();
    this.refresh();
  }

  build() {
    this.input = make('input', {
      type: 'search',
      id: 'filter',
      spellcheck: 'false',
      autocomplete: 'off',
      'aria-describedby': 'filter-help',
      placeholder: filterExample(this.table),
      oninput: () => this.filter(),
    });
    this.counts = make('p', { class: 'counts', role: 'status' });
    this.lines = Array.from({ length: Math.min(ROWS, Math.max(1, this.table.rows)) }, (_, i) =>
      this.makeLine(i),
    );
    this.heads = this.columns.map((column) => this.makeHead(column));
    this.grid = make(
      'table',
      { class: 'runs', role: 'grid', 'aria-label': 'Runs', 'aria-rowcount': this.table.rows + 1 },
      make('thead', null, oneStop(make('tr', { 'aria-rowindex': '1' }, this.heads))),
      make('tbody', null, this.lines),
    );
    this.spacer = make('div', { class: 'spacer' }, this.grid);
    this.window = make(
      'div',
      {
        class: 'window',
        tabindex: '0',
        role: 'region',
        'aria-label': 'Runs, arrow keys and Enter',
        onscroll: () => this.scrolled(),
        onkeydown: (/** @type {KeyboardEvent} */ e) => this.key(e),
      },
      this.spacer,
    );
    this.window.style.height = `${(this.lines.length + 1) * ROW_HEIGHT + 18}px`;
    return card(
      'runs',
      'Runs',
      null,
      make(
        'div',
        { class: 'filter-row' },
        make('label', { for: 'filter' }, 'Filter'),
        this.input,
        this.counts,
      ),
      make(
        'p',
        { class: 'note', id: 'filter-help' },
        'Conditions apart by spaces, all must hold: name=text, name~part, name<number, <=, >, >=, !=, name=nan; a word alone is searched in all texts.',
      ),
      this.window,
    );
  }

  /** @param {number} i */
  makeLine(i) {
    return make(
      'tr',
      { onclick: () => this.open(this.first + i) },
      this.columns.map((column) => make('td', { class: column.dictionary ? 'text' : '' })),
    );
  }

  /** @param {import('./table.js').Column} column */
  makeHead(column) {
    const width = columnWidth(this.table, column);
    return make(
      'th',
      { scope: 'col', style: `width:${width}px`, class: column.dictionary ? 'text' : '' },
      make(
        'button',
        { type: 'button', title: column.meaning || null, onclick: () => this.sort(column.name) },
        plainName(column.name, column.unit),
        column.unit && make('span', { class: 'unit' }, ` ${column.unit}`),
        make('span', { class: 'arrow', 'aria-hidden': 'true' }),
      ),
    );
  }

  /**
   * Sorts by a column; by the same one again, the other way round.
   * @param {string} name
   * @param {boolean} [falling]
   */
  sort(name, falling) {
    const column = this.table.byName.get(name);
    if (!column) return;
    this.falling =
      falling ?? (this.sorted_by === column ? !this.falling : !column.dictionary && name !== 'run');
    this.sorted_by = column;
    this.order();
  }

  /** @param {string} [text] */
  filter(text) {
    if (text !== undefined) this.input.value = text;
    const answer = filterRows(this.table, this.input.value);
    const problem = 'problem' in answer ? answer.problem : '';
    this.input.setAttribute('aria-invalid', String(problem !== ''));
    if ('rows' in answer) {
      this.found = answer.rows;
      this.order();
    }
    if (problem) this.counts.textContent = problem;
  }

  order() {
    this.rows = this.sorted_by ? sortRows(this.found, this.sorted_by, this.falling) : this.found;
    this.heads.forEach((head, i) => {
      const active = this.columns[i] === this.sorted_by;
      head.setAttribute('aria-sort', active ? (this.falling ? 'descending' : 'ascending') : 'none');
    });
    this.current = 0;
    this.window.scrollTop = 0;
    this.refresh();
  }

  /** Counts, height and lines after the rows have changed. */
  refresh() {
    const successes = this.rows.reduce((sum, row) => sum + (this.table.isSuccess(row) ? 1 : 0), 0);
    const all = this.rows.length === this.table.rows;
    this.counts.textContent =
      this.rows.length === 0
        ? 'No run fits the filter.'
        : `${group(successes)} of ${group(this.rows.length)} ${all ? '' : 'chosen '}runs ${this.table.word}`;
    const height = Math.min(TALLEST, (this.rows.length + 1) * ROW_HEIGHT);
    this.spacer.style.height = `${height}px`;
    this.grid.setAttribute('aria-rowcount', String(this.rows.length + 1));
    this.scrolled();
  }

  scrolled() {
    const most = Math.max(0, this.rows.length - this.lines.length);
    const way = this.window.scrollHeight - this.window.clientHeight;
    this.show(way > 0 ? Math.round((this.window.scrollTop / way) * most) : 0);
  }

  /** @param {number} first */
  show(first) {
    this.first = first;
    this.lines.forEach((line, i) => {
      const place = first + i;
      const there = place < this.rows.length;
      line.style.visibility = there ? '' : 'hidden';
      if (there) this.fillLine(line, place);
    });
  }

  /** @param {any} line @param {number} place */
  fillLine(line, place) {
    const row = this.rows[place];
    const success = this.table.isSuccess(row);
    line.setAttribute('aria-rowindex', String(place + 2));
    line.setAttribute('aria-selected', String(place === this.current));
    line.className = success ? '' : 'failed';
    this.columns.forEach((column, i) => {
      let text = this.table.text(column, row);
      if (column === this.table.outcomes) text = `${success ? '●' : '✕'} ${text}`;
      if (line.cells[i].textContent !== text) line.cells[i].textContent = text;
    });
  }

  /** @param {number} place */
  open(place) {
    if (place >= this.rows.length) return;
    this.current = place;
    this.show(this.first);
    this.openRun(this.table.run.values[this.rows[place]]);
  }

  /** The run beside this one in the order that is shown, or null. @param {number} run @param {number} step */
  neighbour(run, step) {
    const row = this.table.rowOf(run);
    const place = this.rows.indexOf(row);
    const next = place < 0 ? -1 : place + step;
    return next >= 0 && next < this.rows.length ? this.table.run.values[this.rows[next]] : null;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.target !== this.window) return;
    const steps = {
      ArrowDown: 1,
      ArrowUp: -1,
      PageDown: ROWS - 2,
      PageUp: 2 - ROWS,
      Home: -Infinity,
      End: Infinity,
    };
    if (event.key === 'Enter') return this.open(this.current);
    const step = /** @type {any} */ (steps)[event.key];
    if (step === undefined || event.ctrlKey || event.altKey) return;
    event.preventDefault();
    this.current = Math.min(this.rows.length - 1, Math.max(0, this.current + step));
    this.reveal();
  }

  /** Scrolls until the current line is shown. */
  reveal() {
    const most = Math.max(0, this.rows.length - this.lines.length);
    let first = Math.min(this.first, this.current);
    if (this.current >= first + this.lines.length) first = this.current - this.lines.length + 1;
    const way = this.window.scrollHeight - this.window.clientHeight;
    if (most > 0) this.window.scrollTop = (first / most) * way;
    this.show(Math.min(most, first));
  }
}
