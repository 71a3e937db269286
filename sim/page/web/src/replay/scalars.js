// Numbers over time in panels, with a cursor at the replay's time.

import uPlot from 'uplot';
import { make, themeColour } from '../dom.js';
import { number, plainName, shownFactor, shownUnit } from '../format.js';
import { readChannel } from '../channels.js';

const COLOURS = ['#1f5fa8', '#c8501e', '#1c8a5a', '#7a4fb0', '#9a7b12', '#3a8fb7'];
const HEIGHT = 120;
const TICKS_APART_PX = 16; // least distance of two numbers of the y axis; the library's own leaves one number alone

export class Scalars {
  /** @param {import('./tracks.js').Tracks} tracks @param {(time: number) => void} goTo */
  constructor(tracks, goTo) {
    this.tracks = tracks;
    this.goTo = goTo;
    this.times = Float64Array.from({ length: tracks.samples }, (_, k) => tracks.timeOf(k));
    const scalars = (tracks.replay.scalars ?? []).map((/** @type {any} */ scalar) => ({
      ...scalar,
      values: readChannel(tracks.blobs, scalar.channel, tracks.samples),
    }));
    this.panels = panelsOf(scalars.filter(hasValues)).map((panel) => this.makePanel(panel));
    this.element = make(
      'section',
      { class: 'scalars', 'aria-label': 'Numbers over time' },
      this.panels.map((p) => p.element),
    );
    this.sized = new ResizeObserver(() => this.resize());
    this.sized.observe(this.element);
  }

  /** @param {any} panel */
  makePanel(panel) {
    const factor = shownFactor(panel.unit);
    const series = panel.scalars.map((/** @type {any} */ scalar) =>
      scalar.values.map((/** @type {number} */ v) => v * factor),
    );
    const values = panel.scalars.map(() => make('b'));
    const legend = make(
      'div',
      { class: 'scalar-legend' },
      panel.scalars.map((/** @type {any} */ scalar, /** @type {number} */ i) =>
        make(
          'span',
          { title: `${scalar.meaning ?? ''}${scalar.meaning ? '; ' : ''}${scalar.source}` },
          make('i', { class: scalar.source, style: `border-color:${COLOURS[i % COLOURS.length]}` }),
          plainName(scalar.name, scalar.unit),
          scalar.source === 'truth' ? '' : ` (${scalar.source})`,
          ' ',
          values[i],
        ),
      ),
    );
    const holder = make('div', { class: 'scalar-plot' });
    const unit = shownUnit(panel.unit);
    const element = make(
      'figure',
      { class: 'scalar' },
      make('figcaption', null, panel.group, unit && make('span', { class: 'unit' }, ` ${unit}`)),
      holder,
      legend,
    );
    const cursor = make('div', { class: 'time-cursor' });
    const plot = new uPlot(this.options(panel), [this.times, ...series.map(gapsAsNull)], holder);
    plot.over.append(cursor);
    plot.over.addEventListener('click', () => this.goTo(plot.posToVal(plot.cursor.left ?? 0, 'x')));
    return { element, holder, plot, cursor, series, values };
  }

  /** @param {any} panel */
  options(panel) {
    const axis = {
      stroke: () => themeColour('quiet'),
      grid: { stroke: '#8884', width: 0.5 },
      ticks: { show: false },
      font: '11px system-ui, sans-serif',
    };
    return /** @type {any} */ ({
      width: 300,
      height: HEIGHT,
      legend: { show: false },
      cursor: { sync: { key: 'replay' }, drag: { x: true, y: false }, points: { show: false }, y: false },
      scales: {
        x: { time: false },
        y: {
          range: (/** @type {any} */ _, /** @type {number} */ low, /** @type {number} */ high) =>
            padded(low, high),
        },
      },
      axes: [
        { ...axis, size: 22 },
        { ...axis, size: 46, space: TICKS_APART_PX },
      ],
      series: [
        {},
        ...panel.scalars.map((/** @type {any} */ scalar, /** @type {number} */ i) => ({
          stroke: COLOURS[i % COLOURS.length],
          width: 1.4,
          dash: scalar.source === 'belief' ? [6, 4] : scalar.source === 'sensor' ? [2, 2] : undefined,
          points: { show: false },
        })),
      ],
    });
  }

  resize() {
    for (const { holder, plot } of this.panels) {
      const width = holder.clientWidth;
      if (width > 0 && width !== plot.width) plot.setSize({ width, height: HEIGHT });
    }
    this.draw(this.time ?? 0);
  }

  /** @param {number} time */
  draw(time) {
    this.time = time;
    const { sample } = this.tracks.place(time);
    for (const { plot, cursor, series, values } of this.panels) {
      cursor.style.transform = `translateX(${plot.valToPos(time, 'x').toFixed(1)}px)`;
      series.forEach((/** @type {Float64Array} */ numbers, /** @type {number} */ i) => {
        const text = number(numbers[sample], 3);
        if (values[i].textContent !== text) values[i].textContent = text;
      });
    }
  }

  dispose() {
    this.sized.disconnect();
    for (const { plot } of this.panels) plot.destroy();
  }
}

/** One panel for the scalars of a group that have the same unit. @param {any[]} scalars */
function panelsOf(scalars) {
  const panels = new Map();
  for (const scalar of scalars) {
    const key = `${scalar.group}/${scalar.unit}`;
    if (!panels.has(key)) panels.set(key, { group: scalar.group, unit: scalar.unit ?? '', scalars: [] });
    panels.get(key).scalars.push(scalar);
  }
  return [...panels.values()];
}

/** Whether there is anything to draw. @param {any} scalar */
function hasValues(scalar) {
  return scalar.values.some((/** @type {number} */ v) => !Number.isNaN(v));
}

/** @param {Float64Array} values */
function gapsAsNull(values) {
  return Array.from(values, (v) => (Number.isNaN(v) ? null : v));
}

/** @param {number | null} low @param {number | null} high @returns {[number, number]} */
function padded(low, high) {
  if (low === null || high === null) return [0, 1];
  const pad = high > low ? 0.06 * (high - low) : 0.1 * Math.abs(high) || 1;
  return [low - pad, high + pad];
}
