// One run: its outcome, its values, the command that replays it, and its replay if there is one.

import { make, outcomeMark } from './dom.js';
import { plainName } from './format.js';
import { Player } from './replay/player.js';

export class RunPanel {
  /**
   * @param {any} header
   * @param {import('./payload.js').Blobs} blobs
   * @param {import('./table.js').Table} table
   * @param {import('./runs_table.js').RunsTable} runs
   */
  constructor(header, blobs, table, runs) {
    this.header = header;
    this.blobs = blobs;
    this.table = table;
    this.runs = runs;
    this.replays = new Map((header.replays ?? []).map((/** @type {any} */ r) => [r.run, r]));
    /** @type {Player | null} */
    this.player = null;
    this.element = make('main', { id: 'run', hidden: true, onclick: leaveButton });
    document.addEventListener('keydown', (e) => this.key(e)); // wherever the focus is
  }

  /** @param {number} row */
  open(row) {
    this.close();
    this.run = this.table.run.values[row];
    const replay = this.replays.get(this.run);
    const problem = this.makePlayer(replay);
    this.element.replaceChildren(
      ...[
        this.head(row, replay),
        problem && make('p', { role: 'alert', class: 'problem' }, problem),
        this.player?.element,
        this.values(row, replay),
        messages(replay),
      ].filter(Boolean),
    );
    this.element.hidden = false;
    this.player?.resize();
    this.element.querySelector('h1')?.focus();
  }

  /** A sentence if there is no replay to show. @param {any} replay */
  makePlayer(replay) {
    if (!replay) return 'This report holds no replay of this run. The command above makes its log again.';
    try {
      this.player = new Player(this.header, replay, this.blobs);
      return null;
    } catch (problem) {
      this.player = null;
      return `The replay of this run cannot be shown: ${problem instanceof Error ? problem.message : problem}.`;
    }
  }

  close() {
    this.player?.dispose();
    this.player = null;
    this.element.hidden = true;
    this.element.replaceChildren();
  }

  /** @param {number} row @param {any} replay */
  head(row, replay) {
    const campaign = Boolean(this.header.campaign) || this.table.rows > 1;
    const command = replay?.command ?? commandOf(this.header, this.run);
    return make(
      'header',
      { class: 'run-head' },
      make(
        'div',
        { class: 'run-title' },
        campaign &&
          make(
            'button',
            {
              type: 'button',
              class: 'back',
              onclick: () => {
                location.hash = '';
              },
            },
            '← All runs',
          ),
        make('h1', { tabindex: '-1' }, replay?.title ?? `Run ${this.run}`),
        outcomeMark(this.table.outcome(row), this.table.isSuccess(row)),
        campaign && this.neighbours(),
      ),
      make('p', { class: 'sentence' }, replay?.sentence ?? this.meaning(row)),
      command &&
        make(
          'p',
          { class: 'command' },
          make('span', null, 'Run it again: '),
          make('code', null, command),
          copyButton(command),
        ),
    );
  }

  neighbours() {
    const button = (/** @type {string} */ text, /** @type {string} */ name, /** @type {number} */ step) => {
      const run = this.runs.neighbour(this.run, step);
      return make(
        'button',
        {
          type: 'button',
          disabled: run === null,
          'aria-label': `${name} in the table's order`,
          onclick: () => {
            location.hash = `run=${run}`;
          },
        },
        text,
      );
    };
    return make(
      'span',
      { class: 'neighbours' },
      button('‹ Run before', 'Run before', -1),
      button('Next run ›', 'Next run', 1),
    );
  }

  /** @param {number} row */
  meaning(row) {
    const known = (this.header.system?.outcomes ?? []).find(
      (/** @type {any} */ o) => o.name === this.table.outcome(row),
    );
    return known?.meaning ?? '';
  }

  /** @param {number} row @param {any} replay */
  values(row, replay) {
    const extra = [
      ['seed', replay?.seed],
      ['state hash', replay?.state_hash],
      ['program', this.header.program],
    ].filter(([, text]) => text);
    return make(
      'section',
      { class: 'card values', 'aria-labelledby': 'values-head' },
      make('h2', { id: 'values-head' }, 'Values of the run'),
      make(
        'dl',
        null,
        this.table.columns
          .filter((column) => column.name !== 'replay')
          .map((column) => {
            const { unit } = column,
              text = this.table.text(column, row);
            return make(
              'div',
              { title: column.meaning || null },
              make('dt', null, plainName(column.name, column.unit)),
              make(
                'dd',
                { class: column.dictionary ? null : 'number' },
                text || '–',
                unit && text !== '–' && make('span', { class: 'unit' }, ` ${unit}`),
              ),
            );
          }),
        extra.map(([name, text]) =>
          make('div', null, make('dt', null, name), make('dd', null, make('code', null, text))),
        ),
      ),
    );
  }

  /** Keys of the run's view, but for those of a field or of a button that has the focus. @param {KeyboardEvent} event */
  key(event) {
    if (this.element.hidden || event.defaultPrevented) return;
    const target = /** @type {HTMLElement} */ (event.target);
    if (event.key === 'Escape' && this.header.campaign) location.hash = '';
    else if (
      target.tagName === 'BUTTON' ? event.key !== ' ' : !/^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)
    ) {
      this.player?.transport.key(event);
    }
  }

  frame() {
    return this.player ? { run: this.run, ...this.player.frame() } : null;
  }
}

/** A button that the mouse has pressed gives the focus back, so that Space plays. @param {MouseEvent} event */
function leaveButton(event) {
  const button = /** @type {HTMLElement} */ (event.target).closest('button');
  if (event.detail > 0) button?.blur();
}

/** @param {any} header @param {number} run */
function commandOf(header, run) {
  return header.replay_command ? header.replay_command.replaceAll('{run}', String(run)) : null;
}

/** @param {string} command */
function copyButton(command) {
  const button = make(
    'button',
    {
      type: 'button',
      class: 'no-print',
      onclick: async () => {
        try {
          await navigator.clipboard.writeText(command);
        } catch {
          const field = make('textarea', null, command);
          document.body.append(field);
          field.select();
          document.execCommand('copy');
          field.remove();
        }
        button.textContent = 'Copied';
        setTimeout(() => {
          button.textContent = 'Copy';
        }, 1500);
      },
    },
    'Copy',
  );
  return button;
}

/** @param {any} replay */
function messages(replay) {
  if (!replay?.messages) return null;
  return make('section', { class: 'card' }, make('h2', null, 'Messages'), make('pre', null, replay.messages));
}
