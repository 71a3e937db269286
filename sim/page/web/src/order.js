// Which rows of the table are shown, in which order: arrays of row numbers, no copies of rows.

/** @typedef {import('./table.js').Column} Column */
/** @typedef {import('./table.js').Table} Table */

/** @param {number} count @returns {Uint32Array} */
export function allRows(count) {
  const rows = new Uint32Array(count);
  for (let i = 0; i < count; ++i) rows[i] = i;
  return rows;
}

/**
 * The rows in the order of a column. Equal values keep the order of the rows; missing values stand last.
 * @param {Uint32Array} rows in rising order
 * @param {Column} column
 * @param {boolean} falling
 * @returns {Uint32Array}
 */
export function sortRows(rows, column, falling) {
  const rank = column.dictionary ? dictionaryRanks(column.dictionary) : null;
  const keys = new Float64Array(rows.length);
  for (let i = 0; i < rows.length; ++i) {
    const value = column.values[rows[i]];
    const key = rank ? rank[value] : value;
    keys[i] = Number.isNaN(key) ? Infinity : falling ? -key : key;
  }
  const places = allRows(rows.length);
  places.sort((a, b) => keys[a] - keys[b] || a - b);
  return places.map((place) => rows[place]);
}

/** @param {string[]} texts @returns {number[]} */
function dictionaryRanks(texts) {
  const compare = new Intl.Collator('en', { numeric: true }).compare;
  const order = texts.map((_, code) => code).sort((a, b) => compare(texts[a], texts[b]));
  const ranks = new Array(texts.length);
  order.forEach((code, rank) => {
    ranks[code] = rank;
  });
  return ranks;
}
