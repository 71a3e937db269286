// Making elements of the page. Text always becomes a text node, never markup.

/** @typedef {Node | string | number | null | undefined | false} Child */

/**
 * Makes an element.
 * @param {string} tag
 * @param {Record<string, any> | null} [attributes] `class`, `onclick` and so on; false and null are left out
 * @param {...(Child | Child[])} children
 * @returns {any} the element
 */
export function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name in element && typeof value !== 'string') element[name] = value;
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.flat().filter(isShown).map(asNode));
  return element;
}

/** @param {Child} child */
function isShown(child) {
  return child !== null && child !== undefined && child !== false;
}

/** @param {any} child */
function asNode(child) {
  return child instanceof Node ? child : String(child);
}

/**
 * A section of the overview with its heading and a sentence below it.
 * @param {string} id
 * @param {string} heading
 * @param {Child} note
 * @param {...(Child | Child[])} children
 */
export function card(id, heading, note, ...children) {
  return make(
    'section',
    { id, class: 'card', 'aria-labelledby': `${id}-head` },
    make('h2', { id: `${id}-head` }, heading),
    note && make('p', { class: 'note' }, note),
    ...children,
  );
}

/**
 * A run's outcome as text with a sign: the sign differs in shape, not only in colour.
 * @param {string} outcome
 * @param {boolean} docked
 */
export function outcomeMark(outcome, docked) {
  return make(
    'span',
    { class: docked ? 'outcome docked' : 'outcome failed' },
    make('span', { 'aria-hidden': 'true', class: 'sign' }, docked ? '●' : '✕'),
    ' ',
    outcome,
  );
}

/**
 * The head of a table: a name over each column.
 * @param {string[]} names
 * @param {(name: string) => string | null} [classOf]
 */
export function tableHead(names, classOf = () => null) {
  const cells = names.map((name) => make('th', { scope: 'col', class: classOf(name) }, name));
  return make('thead', null, make('tr', null, cells));
}

/** The colour that the style sheet gives a name. @param {string} name */
export function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
