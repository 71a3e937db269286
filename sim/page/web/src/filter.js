// The filter of the table: `outcome=timeout soil=loose tip_depth_m<0.2`. All conditions must hold.

/** @typedef {import('./table.js').Column} Column */
/** @typedef {import('./table.js').Table} Table */
/** @typedef {(row: number) => boolean} Condition */

const CONDITION = /^([^\s=!<>~]+)(<=|>=|!=|=|<|>|~)(.*)$/;

/**
 * The rows for which the filter holds, or a sentence that says what is wrong with it.
 * @param {Table} table
 * @param {string} text
 * @returns {{rows: Uint32Array} | {problem: string}}
 */
export function filterRows(table, text) {
  /** @type {Condition[]} */
  const conditions = [];
  for (const word of text.match(/[^\s"]*"[^"]*"|\S+/g) ?? []) {
    const condition = readWord(table, word);
    if (typeof condition === 'string') return { problem: condition };
    conditions.push(condition);
  }
  const rows = new Uint32Array(table.rows);
  let count = 0;
  for (let row = 0; row < table.rows; ++row) {
    let holds = true;
    for (let i = 0; holds && i < conditions.length; ++i) holds = conditions[i](row);
    if (holds) rows[count++] = row;
  }
  return { rows: rows.subarray(0, count) };
}

/** @param {Table} table @param {string} word @returns {Condition | string} */
function readWord(table, word) {
  const parts = CONDITION.exec(word);
  if (!parts) return anyText(table, word.replaceAll('"', ''));
  const [, name, relation, quoted] = parts;
  const column =
    table.byName.get(name) ?? table.columns.find((c) => c.name.toLowerCase() === name.toLowerCase());
  if (!column) return `There is no column "${name}".`;
  const wanted = quoted.replaceAll('"', '');
  if (wanted === '') return `A value is missing after "${name}${relation}".`;
  return column.dictionary
    ? textCondition(column, relation, wanted)
    : numberCondition(column, relation, wanted);
}

/**
 * A word alone: any column of text that contains it.
 * @param {Table} table
 * @param {string} word
 * @returns {Condition}
 */
function anyText(table, word) {
  const small = word.toLowerCase();
  const checks = table.columns
    .filter((c) => c.dictionary)
    .map((column) => ({
      values: column.values,
      fits: /** @type {string[]} */ (column.dictionary).map((text) => text.toLowerCase().includes(small)),
    }));
  const run = table.run.values;
  return (row) => String(run[row]) === word || checks.some((check) => check.fits[check.values[row]]);
}

/** @param {Column} column @param {string} relation @param {string} wanted @returns {Condition | string} */
function textCondition(column, relation, wanted) {
  const texts = /** @type {string[]} */ (column.dictionary);
  const values = column.values;
  const as_number = Number(wanted);
  /** @param {string} text */
  const holds = (text) => {
    switch (relation) {
      case '=':
        return text === wanted;
      case '!=':
        return text !== wanted;
      case '~':
        return text.toLowerCase().includes(wanted.toLowerCase());
      default:
        return text !== '' && compare(Number(text), relation, as_number);
    }
  };
  const fits = texts.map(holds);
  return (row) => fits[values[row]] === true;
}

/** @param {Column} column @param {string} relation @param {string} wanted @returns {Condition | string} */
function numberCondition(column, relation, wanted) {
  const values = column.values;
  if (wanted === 'nan' || wanted === 'none') {
    const missing = relation !== '!=';
    return (row) => Number.isNaN(values[row]) === missing;
  }
  const limit = Number(wanted);
  if (Number.isNaN(limit)) return `"${wanted}" is not a number, and ${column.name} is a column of numbers.`;
  switch (relation) {
    case '<':
      return (row) => values[row] < limit;
    case '<=':
      return (row) => values[row] <= limit;
    case '>':
      return (row) => values[row] > limit;
    case '>=':
      return (row) => values[row] >= limit;
    case '!=':
      return (row) => values[row] !== limit;
    case '~':
      return `${column.name} is a column of numbers; "~" searches in text.`;
    default:
      return (row) => values[row] === limit || Math.fround(limit) === values[row];
  }
}

/** @param {number} value @param {string} relation @param {number} limit */
function compare(value, relation, limit) {
  if (relation === '<') return value < limit;
  if (relation === '<=') return value <= limit;
  if (relation === '>') return value > limit;
  return value >= limit;
}
