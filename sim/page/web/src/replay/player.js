// The replay of one run: view, cameras, numbers and time, tied together.

import { make, tableHead } from '../dom.js';
import { fixed } from '../format.js';
import { Clock } from './clock.js';
import { PlanView } from './plan_view.js';
import { Scalars } from './scalars.js';
import { Sightings } from './sightings.js';
import { Tracks } from './tracks.js';
import { Transport } from './transport.js';
import { View3d } from './view3d.js';

export class Player {
  /** @param {any} header @param {any} replay @param {import('../payload.js').Blobs} blobs */
  constructor(header, replay, blobs) {
    this.header = header;
    this.blobs = blobs;
    this.tracks = new Tracks(replay, header.scenes[replay.scene], blobs);
    this.clock = new Clock(this.tracks.end_s, this.tracks.period_s, () => this.draw());
    const goTo = (/** @type {number} */ time) => {
      this.clock.stop();
      this.clock.goTo(time);
    };
    this.sightings = new Sightings(this.tracks, goTo);
    this.scalars = new Scalars(this.tracks, goTo);
    this.transport = new Transport(this.clock, this.tracks);
    this.poses = make('div', { class: 'poses' });
    this.note = make('p', { class: 'note', role: 'status' });
    this.stage = make('div', { class: 'stage-holder' });
    this.build();
    this.frame_ms = 0;
    this.view = this.makeView(true);
    this.sized = new ResizeObserver(() => this.resize());
    this.sized.observe(this.stage);
    this.draw();
  }

  build() {
    this.followed = make(
      'button',
      { type: 'button', 'aria-pressed': 'false', onclick: () => this.follow() },
      'Follow robot',
    );
    this.near = make(
      'button',
      { type: 'button', 'aria-pressed': 'false', onclick: () => this.goNear(!isPressed(this.near)) },
      'Near target',
    );
    this.near.hidden = !this.tracks.near;
    this.flat = make(
      'button',
      { type: 'button', 'aria-pressed': 'false', onclick: () => this.switchView() },
      'From above',
    );
    const tools = make(
      'div',
      { class: 'tools' },
      this.followed,
      this.near,
      make('button', { type: 'button', onclick: () => this.reset() }, 'Reset view'),
      this.flat,
    );
    this.element = make(
      'div',
      { class: 'player' },
      make(
        'div',
        { class: 'player-main' },
        make(
          'div',
          { class: 'player-left' },
          make('div', { class: 'stage-frame' }, this.stage, tools, viewLegend(this.tracks)),
          this.note,
          this.transport.element,
          this.poses,
        ),
        make('div', { class: 'player-right' }, this.sightings.element),
      ),
      this.scalars.element,
    );
  }

  /** In three dimensions if this browser can, else from above. @param {boolean} solid */
  makeView(solid) {
    let view = null;
    if (solid) {
      try {
        view = new View3d(this.tracks, this.header, this.blobs);
      } catch {
        this.note.textContent = 'This browser has no WebGL: the run is shown from above.';
        this.flat.hidden = true;
      }
    }
    view ??= new PlanView(this.tracks, this.header, this.blobs);
    this.stage.replaceChildren(view.canvas);
    return view;
  }

  switchView() {
    const flat = this.view instanceof View3d;
    this.view.dispose();
    this.view = this.makeView(!flat);
    this.flat.setAttribute('aria-pressed', String(flat));
    this.resize();
    this.view.follow(isPressed(this.followed));
    this.draw();
    if (isPressed(this.near)) this.view.goNear(true);
  }

  follow() {
    const on = !isPressed(this.followed);
    if (on && isPressed(this.near)) this.goNear(false);
    this.followed.setAttribute('aria-pressed', String(on));
    this.view.follow(on);
  }

  /** The target's point from near, over the whole run. @param {boolean} on */
  goNear(on) {
    if (on && isPressed(this.followed)) this.follow();
    this.near.setAttribute('aria-pressed', String(on));
    this.view.goNear(on);
  }

  reset() {
    if (isPressed(this.near)) this.goNear(false);
    this.view.reset();
  }

  resize() {
    const { clientWidth, clientHeight } = this.stage;
    if (clientWidth > 0 && clientHeight > 0) this.view.resize(clientWidth, clientHeight);
  }

  draw() {
    if (!this.view) return;
    const begin = performance.now();
    const { time } = this.clock;
    this.view.draw(time);
    this.sightings.draw(time);
    this.scalars.draw(time);
    this.transport.update();
    this.drawPoses(time);
    this.frame_ms = performance.now() - begin;
  }

  /** @param {number} time */
  drawPoses(time) {
    const truth = this.tracks.truePose(time),
      believed = this.tracks.believedPose(time);
    if (!truth) return;
    if (!this.cells) this.makePoseTable();
    const cells = /** @type {any[][]} */ (this.cells);
    const text = (/** @type {number[] | null} */ pose) =>
      pose
        ? [fixed(pose[0], 3), fixed(pose[1], 3), fixed((wrapped(pose[2]) * 180) / Math.PI, 1)]
        : ['–', '–', '–'];
    const off = believed ? [0, 1, 2].map((i) => believed[i] - truth[i]) : null;
    const rows = [
      text(truth),
      text(believed),
      off
        ? [
            `${fixed(1000 * off[0], 0)} mm`,
            `${fixed(1000 * off[1], 0)} mm`,
            fixed((wrapped(off[2]) * 180) / Math.PI, 1),
          ]
        : ['–', '–', '–'],
    ];
    rows.forEach((row, r) =>
      row.forEach((value, c) => {
        if (cells[r][c].textContent !== value) cells[r][c].textContent = value;
      }),
    );
  }

  makePoseTable() {
    this.cells = [0, 1, 2].map(() => [0, 1, 2].map(() => make('td')));
    const names = [
      make('span', { class: 'truth-key' }, 'true'),
      make('span', { class: 'belief-key' }, 'believed'),
      'difference',
    ];
    this.poses.replaceChildren(
      make(
        'table',
        { class: 'plain' },
        tableHead(['Robot, target’s frame', 'x [m]', 'y [m]', 'heading [deg]']),
        make(
          'tbody',
          null,
          this.cells.map((cells, i) => make('tr', null, make('th', { scope: 'row' }, names[i]), cells)),
        ),
      ),
    );
  }

  /** What is drawn now, for tests. */
  frame() {
    return {
      time: this.clock.time,
      poses: this.view.drawn(),
      solid: this.view instanceof View3d,
      frame_ms: this.frame_ms,
      framed: this.view.framed(),
      framed_near: this.view.framedNear(),
    };
  }

  dispose() {
    this.clock.stop();
    this.sized.disconnect();
    this.scalars.dispose();
    this.view.dispose();
  }
}

/** @param {import('./tracks.js').Tracks} tracks */
function viewLegend(tracks) {
  return make(
    'p',
    { class: 'view-legend' },
    tracks.truth && make('span', { class: 'truth-key' }, 'true'),
    tracks.believed && make('span', { class: 'belief-key' }, 'believed'),
    tracks.plans.length > 0 && make('span', { class: 'plan-key' }, 'plan'),
    tracks.scene.bodies.some((/** @type {any} */ b) => b.leaves) &&
      make('span', { class: 'leaf-key' }, 'leaves that throw the speckled shade'),
  );
}

/** @param {any} button */
function isPressed(button) {
  return button.getAttribute('aria-pressed') === 'true';
}

/** @param {number} angle */
function wrapped(angle) {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}
