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
 * @param {boolean} success
 */
export function outcomeMark(outcome, success) {
  return make(
    'span',
    { class: success ? 'outcome success' : 'outcome failed' },
    make('span', { 'aria-hidden': 'true', class: 'sign' }, success ? '●' : '✕'),
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

const STEPS = /** @type {Record<string, number>} */ ({
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  Home: -Infinity,
  End: Infinity,
});

/**
 * Makes the buttons of a group one stop of the Tab key; arrow keys go from one to the next.
 * @param {any} group @returns {any} the group
 */
export function oneStop(group) {
  const buttons = () => [...group.querySelectorAll('button')];
  /** @param {any} stop */
  const mark = (stop) => {
    for (const button of buttons()) button.tabIndex = button === stop ? 0 : -1;
  };
  mark(buttons()[0]);
  group.addEventListener('focusin', (/** @type {FocusEvent} */ event) => {
    if (buttons().includes(event.target)) mark(event.target);
  });
  group.addEventListener('keydown', (/** @type {KeyboardEvent} */ event) => {
    const list = buttons(),
      step = STEPS[event.key];
    if (step === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    const place = list.indexOf(event.target) + step;
    event.preventDefault();
    event.stopPropagation();
    list[Math.min(list.length - 1, Math.max(0, place))]?.focus();
  });
  return group;
}

/** The colour that the style sheet gives a name. @param {string} name */
export function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
