// What the cameras saw at the last sighting, with what the controller found drawn in.

import { make } from '../dom.js';
import { fixed } from '../format.js';

const KEPT = 12; // decoded images

export class Sightings {
  /** @param {import('./tracks.js').Tracks} tracks @param {(time: number) => void} goTo */
  constructor(tracks, goTo) {
    this.tracks = tracks;
    this.list = [...tracks.sightings, ...tracks.images].sort((a, b) => a.sample - b.sample);
    this.shown = -2;
    /** @type {Map<string, Promise<ImageBitmap>>} */
    this.images = new Map();
    this.head = make('p', { class: 'sighting-head' });
    this.facts = make('p', { class: 'note' });
    this.figures = make('div', { class: 'cameras' });
    const jump = (/** @type {number} */ step) => {
      const next = Math.min(this.list.length - 1, Math.max(0, this.shown + step));
      goTo(tracks.timeOf(this.list[next].sample));
    };
    const what = tracks.sightings.length > 0 ? 'Sighting' : 'Image';
    this.element = make(
      'section',
      { class: 'sightings', 'aria-label': 'Sightings' },
      make(
        'div',
        { class: 'sighting-row' },
        make('h2', null, 'Cameras'),
        make('button', { type: 'button', 'aria-label': `${what} before`, onclick: () => jump(-1) }, '‹'),
        make('button', { type: 'button', 'aria-label': `Next ${what.toLowerCase()}`, onclick: () => jump(1) }, '›'),
      ),
      this.head,
      this.figures,
      this.facts,
      make('p', { class: 'note' }, howMany(tracks)),
    );
    if (this.list.length === 0) this.element.hidden = true;
  }

  /** @param {number} time */
  draw(time) {
    const at = this.tracks.latest(this.list, time);
    if (at === this.shown || this.list.length === 0) return;
    this.shown = at;
    if (at < 0) {
      this.head.textContent = this.tracks.sightings.length > 0 ? 'No sighting yet.' : 'No image yet.';
      this.facts.textContent = '';
      this.figures.replaceChildren();
      return;
    }
    const sighting = this.list[at];
    this.head.replaceChildren(...this.headOf(sighting));
    this.facts.textContent = sightingFacts(sighting);
    this.figures.replaceChildren(
      ...(sighting.cameras ?? []).map((/** @type {any} */ camera, /** @type {number} */ i) =>
        this.figure(camera, `${at}/${i}`),
      ),
    );
  }

  /** Number, time and verdict. @param {any} sighting */
  headOf(sighting) {
    const { sightings, images } = this.tracks;
    const of = sightings.includes(sighting) ? sightings : images;
    const when = `${of.indexOf(sighting) + 1} of ${of.length}, ${this.tracks.timeOf(sighting.sample).toFixed(1)} s`;
    if (of === images) return [`Images ${when}: `, make('span', { class: 'quiet' }, 'no sighting reported')];
    return [
      `Sighting ${when}: `,
      make(
        'span',
        { class: sighting.accepted ? 'success' : 'failed' },
        sighting.accepted ? '● accepted' : '✕ not accepted',
      ),
      sighting.accepted ? (sighting.method ? ` (${sighting.method})` : '') : `: ${sighting.reason}`,
    ];
  }

  /** @param {any} camera @param {string} key */
  figure(camera, key) {
    const canvas = make('canvas', {
      width: camera.width,
      height: camera.height,
      role: 'img',
      'aria-label': `Image of the ${camera.name} camera${camera.marks ? ` with ${marks(camera.marks.length)}` : ''}`,
    });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.fillStyle = '#777';
    context.fillRect(0, 0, camera.width, camera.height);
    const measured = (camera.marks ?? []).filter((/** @type {any} */ m) => m[3]).length;
    drawMarks(context, camera);
    if (camera.picture) {
      this.image(key, camera.picture)
        .then((image) => {
          context.drawImage(image, 0, 0, camera.width, camera.height);
          drawMarks(context, camera);
        })
        .catch(() => note(context, 'The image is damaged.'));
    } else note(context, 'The log keeps no image of this time.', 'dockyard report --all-images makes it.');
    return make(
      'figure',
      null,
      canvas,
      make('figcaption', null, camera.marks ? `${camera.name}: ${marks(measured)} measured` : camera.name),
    );
  }

  /** @param {string} key @param {any} blob @returns {Promise<ImageBitmap>} */
  image(key, blob) {
    const kept = this.images.get(key);
    if (kept) return kept;
    const image = createImageBitmap(new Blob([this.tracks.blobs.bytes(blob)]));
    this.images.set(key, image);
    if (this.images.size > KEPT) this.images.delete(this.images.keys().next().value ?? '');
    return image;
  }
}

/**
 * Measured marks as circles, predicted ones that were not measured as broken circles.
 * @param {CanvasRenderingContext2D} context
 * @param {any} camera
 */
function drawMarks(context, camera) {
  const unit = camera.width / 400; // the canvas is shown about this wide
  context.font = `600 ${13 * unit}px sans-serif`;
  context.lineWidth = 1.6 * unit;
  for (const [u, v, id, measured] of camera.marks ?? []) {
    const colour = measured ? '#39ff8c' : '#ffb03a';
    context.strokeStyle = context.fillStyle = colour;
    context.setLineDash(measured ? [] : [3 * unit, 3 * unit]);
    const x = u + 0.5,
      y = v + 0.5; // pixel (0, 0) is the middle of the first
    context.beginPath();
    context.arc(x, y, 7 * unit, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    if (measured) context.fillRect(x - unit, y - unit, 2 * unit, 2 * unit);
    context.fillText(String(id), x + 8 * unit, y - 6 * unit);
  }
}

/** How many of the log's images without a sighting are here. @param {import('./tracks.js').Tracks} tracks */
function howMany(tracks) {
  const images = tracks.replay.images;
  if (!images) return null;
  const all = images.taken === images.shown.length;
  return all
    ? `The images of all ${images.taken} times without a sighting are shown.`
    : `Images without a sighting: ${images.shown.length} of ${images.taken} times are shown; dockyard frames writes all.`;
}

/** @param {number} count */
function marks(count) {
  return count === 1 ? '1 mark' : `${count} marks`;
}

/** @param {CanvasRenderingContext2D} context @param {...string} lines */
function note(context, ...lines) {
  const unit = context.canvas.width / 400;
  context.font = `${14 * unit}px sans-serif`;
  context.fillStyle = '#fff';
  lines.forEach((line, i) => context.fillText(line, 12 * unit, (24 + 20 * i) * unit));
}

/** @param {any} sighting */
function sightingFacts(sighting) {
  const facts = [];
  if (sighting.measured && sighting.pose) {
    const [x, y, turn] = [0, 1, 2].map((i) => sighting.measured[i] - sighting.pose[i]);
    const angle = (Math.atan2(Math.sin(turn), Math.cos(turn)) * 180) / Math.PI;
    facts.push(
      `Measured minus true: x ${fixed(1000 * x, 1)} mm, y ${fixed(1000 * y, 1)} mm, heading ${fixed(angle, 2)}°.`,
    );
  }
  if (typeof sighting.reprojection_px === 'number')
    facts.push(`Reprojection ${fixed(sighting.reprojection_px, 2)} px rms.`);
  return facts.join(' ');
}
