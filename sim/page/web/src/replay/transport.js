// Play, speed, slider, the strip of phases above it, keys.

import { make } from '../dom.js';
import { clock as clockText } from '../format.js';

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50];
const LONG_STEP = 10;

export class Transport {
  /** @param {import('./clock.js').Clock} clock @param {import('./tracks.js').Tracks} tracks */
  constructor(clock, tracks) {
    this.clock = clock;
    this.tracks = tracks;
    this.button = make('button', { type: 'button', class: 'play', onclick: () => clock.toggle() });
    this.slider = make('input', {
      type: 'range',
      min: '0',
      max: String(tracks.end_s),
      step: 'any',
      'aria-label': 'Time',
      oninput: () => {
        const time = Number(this.slider.value); // before a redraw sets it
        clock.stop();
        clock.goTo(time);
      },
      onkeydown: (/** @type {KeyboardEvent} */ event) => this.key(event),
    });
    this.readout = make('output', { class: 'time' });
    this.phase = make('span', { class: 'phase' });
    let by_pointer = false;
    const speeds = make(
      'select',
      {
        'aria-label': 'Speed',
        onchange: () => {
          clock.speed = Number(speeds.value);
          if (by_pointer) speeds.blur(); // Space plays again
        },
        onpointerdown: () => {
          by_pointer = true;
        },
        onkeydown: () => {
          by_pointer = false;
        },
      },
      SPEEDS.map((s) => make('option', { value: String(s), selected: s === clock.speed }, `${s} ×`)),
    );
    this.element = make(
      'div',
      { class: 'transport' },
      make('div', { class: 'strips' }, phaseStrip(tracks), sightingStrip(tracks), this.slider),
      make('div', { class: 'transport-row' }, this.button, speeds, this.readout, this.phase),
    );
    this.update();
  }

  update() {
    const { clock } = this;
    const label = clock.playing ? 'Pause' : 'Play';
    if (this.button.textContent !== label) this.button.textContent = label;
    this.slider.value = String(clock.time);
    const text = `${clockText(clock.time)} of ${clockText(clock.end_s)}`;
    if (this.readout.textContent !== text) {
      this.readout.textContent = text;
      this.slider.setAttribute('aria-valuetext', `${clock.time.toFixed(1)} s`);
    }
    const phase = this.tracks.phase(clock.time);
    if (this.phase.textContent !== phase) this.phase.textContent = phase;
  }

  /** Keys of the whole panel: answers whether it took the key. @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return false;
    const step = event.shiftKey ? LONG_STEP : 1;
    switch (event.key) {
      case ' ':
        this.clock.toggle();
        break;
      case 'ArrowRight':
        this.clock.step(step);
        break;
      case 'ArrowLeft':
        this.clock.step(-step);
        break;
      case 'Home':
        this.clock.stop();
        this.clock.goTo(0);
        break;
      case 'End':
        this.clock.stop();
        this.clock.goTo(this.clock.end_s);
        break;
      default:
        return false;
    }
    event.preventDefault();
    event.stopPropagation();
    return true;
  }
}

/** @param {import('./tracks.js').Tracks} tracks */
function phaseStrip(tracks) {
  const names = [...new Set(tracks.phases.map((/** @type {any} */ p) => p[1]))];
  return make(
    'div',
    { class: 'phases', 'aria-hidden': 'true' },
    tracks.phases.map((/** @type {any} */ [sample, name], /** @type {number} */ i) => {
      const end = i + 1 < tracks.phases.length ? tracks.timeOf(tracks.phases[i + 1][0]) : tracks.end_s;
      const begin = tracks.timeOf(sample),
        share = (end - begin) / (tracks.end_s || 1);
      return make(
        'div',
        {
          class: `kind${names.indexOf(name) % 6}`,
          title: `${name}: ${begin.toFixed(1)} to ${end.toFixed(1)} s`,
          style: `left:${(100 * begin) / (tracks.end_s || 1)}%;width:${100 * share}%`,
        },
        share > 0.03 ? name : '',
      );
    }),
  );
}

/** @param {import('./tracks.js').Tracks} tracks */
function sightingStrip(tracks) {
  return make(
    'div',
    { class: 'sighting-strip', 'aria-hidden': 'true' },
    tracks.images.map((/** @type {any} */ s) =>
      make(
        'span',
        {
          class: 'quiet',
          style: `left:${(100 * tracks.timeOf(s.sample)) / (tracks.end_s || 1)}%`,
          title: 'images',
        },
        '▪',
      ),
    ),
    tracks.sightings.map((/** @type {any} */ s) =>
      make(
        'span',
        {
          class: s.accepted ? 'success' : 'failed',
          style: `left:${(100 * tracks.timeOf(s.sample)) / (tracks.end_s || 1)}%`,
          title: s.accepted ? 'sighting, accepted' : `sighting, not accepted: ${s.reason}`,
        },
        s.accepted ? '▼' : '✕',
      ),
    ),
  );
}
