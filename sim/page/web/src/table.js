// The table of runs: typed columns, no object per row.

import { number } from './format.js';

/**
 * @typedef {object} Column
 * @property {string} name
 * @property {string} unit
 * @property {string} meaning
 * @property {string[] | null} dictionary texts by code, of columns of text
 * @property {any} values typed array, a value or code per row
 */

export class Table {
  /** @param {any} header of the payload @param {import('./payload.js').Blobs} blobs */
  constructor(header, blobs) {
    const meanings = new Map((header.system?.columns ?? []).map((/** @type {any} */ c) => [c.name, c]));
    this.rows = header.table.rows;
    /** @type {Column[]} */
    this.columns = header.table.columns.map((/** @type {any} */ column) => {
      const values = readColumn(column, blobs);
      if (values.length !== this.rows)
        throw new Error(`the column ${column.name} has not a value for each run`);
      const known = meanings.get(column.name);
      return inDegrees({
        name: column.name,
        unit: column.unit ?? known?.unit ?? '',
        meaning: known?.meaning ?? '',
        dictionary: column.dictionary ?? null,
        values,
      });
    });
    addReplayColumn(this.columns, header.replays ?? [], this.rows);
    this.byName = new Map(this.columns.map((column) => [column.name, column]));
    this.outcomes = this.byName.get('outcome');
    this.success = this.byName.get('success');
    this.run = this.byName.get('run');
    /** The system's word for a success: its first one's outcome. @type {string} */
    this.word =
      (header.system?.outcomes ?? []).find((/** @type {any} */ each) => each.success)?.name ?? 'that succeeded';
    if (!this.outcomes || !this.success || !this.run) throw new Error('the table of runs lacks a column');
    this.starts = ['start_x_m', 'start_y_m', 'start_heading_deg'].map(
      (name) => this.byName.get(name)?.values,
    );
    this.success_count = this.success.values.reduce(
      (/** @type {number} */ sum, /** @type {number} */ v) => sum + v,
      0,
    );
  }

  /** @param {number} row */
  isSuccess(row) {
    return this.success.values[row] === 1;
  }

  /** @param {number} row */
  outcome(row) {
    return this.text(this.outcomes, row);
  }

  /** The text of a cell. @param {Column} column @param {number} row */
  text(column, row) {
    const value = column.values[row];
    if (column.dictionary) return column.dictionary[value] ?? '';
    return column === this.run ? String(value) : number(value);
  }

  /** Row of a run's number, -1 if there is none. @param {number} run */
  rowOf(run) {
    if (this.run.values[run] === run) return run;
    return this.run.values.indexOf(run);
  }

  /** The columns that are measured numbers: what a run came to. @returns {Column[]} */
  measures() {
    const other = new Set([
      'run',
      'success',
      'start_x_m',
      'start_y_m',
      'start_heading_deg',
      'cpu_time_s',
      'wall_time_s',
    ]);
    return this.columns.filter((c) => !c.dictionary && !other.has(c.name));
  }
}

/**
 * Which runs have a replay, if only some have.
 * @param {Column[]} columns
 * @param {any[]} replays
 * @param {number} rows
 */
function addReplayColumn(columns, replays, rows) {
  const run = columns.find((column) => column.name === 'run');
  if (!run || replays.length === 0 || replays.length >= rows) return;
  const there = new Set(replays.map((replay) => replay.run));
  columns.push({
    name: 'replay',
    unit: '',
    meaning: 'whether this report holds a replay of the run',
    dictionary: ['', 'yes'],
    values: Uint8Array.from(run.values, (/** @type {number} */ number) => (there.has(number) ? 1 : 0)),
  });
}

/**
 * A column of radians as one of degrees: `yaw_rad` becomes `yaw_deg`.
 * @param {Column} column
 * @returns {Column}
 */
function inDegrees(column) {
  if (column.unit !== 'rad') return column;
  return {
    ...column,
    name: column.name.replace(/_rad$/, '_deg'),
    unit: 'deg',
    values: column.values.map((/** @type {number} */ v) => (v * 180) / Math.PI),
  };
}

/** @param {any} column @param {import('./payload.js').Blobs} blobs */
function readColumn(column, blobs) {
  switch (column.kind) {
    case 'f64':
      return blobs.f64(column.blob);
    case 'f32':
      return blobs.f32(column.blob);
    case 'i32':
      return blobs.i32(column.blob);
    case 'u16':
      return blobs.u16(column.blob);
    case 'u8':
      return blobs.bytes(column.blob);
    default:
      throw new Error(`the column ${column.name} has an unknown kind`);
  }
}
