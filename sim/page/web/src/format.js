// Numbers as text for people.

const MINUS = '−';
const MANY = 2000; // runs, whose shares are worth a tenth of a percent

/**
 * A number with about `digits` significant digits and no needless zeros.
 * @param {number} value
 * @param {number} [digits]
 */
export function number(value, digits = 4) {
  if (Number.isNaN(value)) return '–';
  if (Number.isInteger(value) && Math.abs(value) < 1e9) return group(value);
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) return value.toExponential(2).replace('-', MINUS);
  const before = Math.floor(Math.log10(size)) + 1; // negative for zeros after the point
  const text = value.toFixed(Math.max(0, digits - before));
  return sign(text.includes('.') ? text.replace(/\.?0+$/, '') : text);
}

/** A setting's text: a number with four digits, a word as it is. @param {string} text */
export function setting(text) {
  const value = Number(text);
  return text.trim() === '' || Number.isNaN(value) || text.length < 6 ? text : number(value);
}

/** A fixed number of places. @param {number} value @param {number} places */
export function fixed(value, places) {
  return Number.isNaN(value) ? '–' : sign(value.toFixed(places));
}

/** A count with a thin space between thousands. @param {number} value */
export function group(value) {
  const text = String(Math.abs(value));
  const grouped = text.length > 4 ? text.replace(/\B(?=(\d{3})+(?!\d))/g, ' ') : text;
  return value < 0 ? MINUS + grouped : grouped;
}

/** @param {string} text */
function sign(text) {
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace('-', MINUS);
}

/**
 * A share as percent, with as many places as it needs near 0 and 1, and one of very many runs.
 * @param {number} share
 * @param {number} [runs]
 */
export function percent(share, runs = 0) {
  if (Number.isNaN(share)) return '–';
  const from_end = Math.min(share, 1 - share);
  const places =
    from_end > 0 && from_end < 0.002 ? 3 : (from_end > 0 && from_end < 0.02) || runs >= MANY ? 1 : 0;
  return (share * 100).toFixed(places);
}

/** `76–97 %` @param {[number, number] | null | undefined} limits @param {number} [runs] */
export function interval(limits, runs = 0) {
  return limits ? `${percent(limits[0], runs)}–${percent(limits[1], runs)} %` : '';
}

/** A value's text and unit as the page shows them: radians become degrees. @param {string} unit */
export function shownUnit(unit) {
  return unit === 'rad' ? 'deg' : unit === 'rad/s' ? 'deg/s' : unit;
}

/** What a value in `unit` is multiplied by to be shown. @param {string} unit */
export function shownFactor(unit) {
  return unit === 'rad' || unit === 'rad/s' ? 180 / Math.PI : 1;
}

/**
 * A column's name without the unit that its end repeats: `tip_depth_m` in `m` is `tip depth`.
 * @param {string} name
 */
export function plainName(name, unit = '') {
  const end = `_${unit.replace('/', '_per_').toLowerCase()}`;
  const bare = unit && name.toLowerCase().endsWith(end) ? name.slice(0, -end.length) : name;
  return bare.replaceAll('_', ' ');
}

/** `tip depth [m]` @param {{name: string, unit?: string}} column */
export function axisName(column) {
  const unit = shownUnit(column.unit ?? '');
  return unit ? `${plainName(column.name, column.unit)} [${unit}]` : plainName(column.name);
}

/** `1:32.4` @param {number} seconds */
export function clock(seconds) {
  const tenths = Math.round(seconds * 10);
  const minutes = Math.floor(tenths / 600);
  return `${minutes}:${((tenths - minutes * 600) / 10).toFixed(1).padStart(4, '0')}`;
}
