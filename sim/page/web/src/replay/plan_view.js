// The replay from above on a flat canvas: needs no WebGL.

import { bodyCorners, convexHull } from './hull.js';
import { GroundHeights } from './ground_heights.js';
import { compose, turned } from './poses.js';

const TRUTH = '#1f5fa8',
  BELIEF = '#c46a08',
  PLAN = '#1c8a5a',
  INK = '#3a3f45',
  PAPER = '#e9e2d4',
  RUT = '#b39f7d';

export class PlanView {
  /**
   * @param {import('./tracks.js').Tracks} tracks
   * @param {any} header
   * @param {import('../payload.js').Blobs} blobs
   */
  constructor(tracks, header, blobs) {
    this.tracks = tracks;
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'stage';
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'The run from above.');
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    this.following = false;
    this.is_near = false;
    this.time = 0;
    this.corners = new Map(
      tracks.bodies.map((/** @type {any} */ { body }) => [
        body,
        bodyCorners(tracks.scene.bodies[body], header.meshes ?? [], blobs),
      ]),
    );
    this.ground = tracks.ground ? new GroundHeights(tracks.ground, blobs) : null;
    this.ruts = new Set();
  }

  reset() {
    this.draw(this.time);
  }

  /** @param {boolean} following */
  follow(following) {
    this.following = following;
    this.draw(this.time);
  }

  /** @param {boolean} is_near */
  goNear(is_near) {
    this.is_near = is_near;
    this.draw(this.time);
  }

  /** @param {number} width @param {number} height */
  resize(width, height) {
    const ratio = Math.min(2, window.devicePixelRatio);
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    this.draw(this.time);
  }

  /** @param {number} time */
  draw(time) {
    this.time = time;
    const { tracks, context, canvas } = this;
    this.poses = tracks.poses(time);
    this.aim();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = PAPER;
    context.fillRect(0, 0, canvas.width, canvas.height);
    this.drawRuts(tracks.place(time).sample);
    this.drawGrid();
    const plan = tracks.latest(tracks.plans, time);
    if (plan >= 0) {
      this.stroke(
        tracks.plans[plan].points.map((/** @type {number[]} */ p) => compose(tracks.X_WD, [p[0], p[1], 0])),
        PLAN,
        2,
        [],
      );
    }
    this.stroke(tracks.trail('truth', time).points, TRUTH, 2, []);
    this.stroke(tracks.trail('believed', time).points, BELIEF, 2, [7, 5]);
    for (const [body, pose] of this.poses)
      if (!tracks.scene.bodies[body].leaves)
        this.drawBody(body, pose, tracks.scene.bodies[body].robot ? TRUTH : INK, true);
    for (const [body, pose] of tracks.ghost(time) ?? []) this.drawBody(body, pose, BELIEF, false);
    for (const line of tracks.lines) this.stroke(tracks.linePoints(line, time), '#111', 2, []);
  }

  /** Scale and middle: the whole way, 4 m about the robot, or 0.8 m about the target's point. */
  aim() {
    const { canvas, tracks } = this;
    let [x0, y0, x1, y1] = tracks.extent();
    const robot = tracks.bodies.find((/** @type {any} */ b) => tracks.scene.bodies[b.body].robot);
    if (this.following && robot) {
      const [x, y] = this.poses?.get(robot.body) ?? [0, 0];
      [x0, y0, x1, y1] = [x - 1, y - 1, x + 1, y + 1];
    }
    const point = this.is_near ? tracks.nearPoint(this.time) : null;
    const margin = point ? 0.8 : 2.2;
    if (point) [x0, y0, x1, y1] = [point[0], point[1], point[0], point[1]];
    this.middle = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.scale = Math.min(canvas.width / (x1 - x0 + margin), canvas.height / (y1 - y0 + margin));
  }

  /** @param {number} x @param {number} y @returns {[number, number]} */
  pixel(x, y) {
    const [mx, my] = /** @type {number[]} */ (this.middle);
    const scale = this.scale ?? 1;
    return [this.canvas.width / 2 + (x - mx) * scale, this.canvas.height / 2 - (y - my) * scale];
  }

  /** @param {number} sample */
  drawRuts(sample) {
    const ground = this.ground;
    if (!ground) return;
    for (const cell of ground.goTo(sample)) this.ruts.add(cell);
    const size = Math.max(1, ground.cell * (this.scale ?? 1));
    this.context.fillStyle = RUT;
    for (const cell of this.ruts) {
      const depth = ground.first[cell] - ground.now[cell];
      if (Math.abs(depth) < 0.002) continue;
      const [u, v] = this.pixel(
        ground.x0 + (cell % ground.columns) * ground.cell,
        ground.y0 + Math.floor(cell / ground.columns) * ground.cell,
      );
      this.context.globalAlpha = Math.min(1, 0.25 + Math.abs(depth) / 0.04);
      this.context.fillRect(u - size / 2, v - size / 2, size, size);
    }
    this.context.globalAlpha = 1;
  }

  /** A line at each metre, and a scale. */
  drawGrid() {
    const { canvas, context } = this;
    const scale = this.scale ?? 1,
      [mx, my] = /** @type {number[]} */ (this.middle);
    const wide = canvas.width / scale / 2,
      tall = canvas.height / scale / 2;
    context.strokeStyle = '#00000018';
    context.lineWidth = 1;
    context.beginPath();
    for (let x = Math.ceil(mx - wide); x <= mx + wide; ++x) {
      context.moveTo(this.pixel(x, 0)[0], 0);
      context.lineTo(this.pixel(x, 0)[0], canvas.height);
    }
    for (let y = Math.ceil(my - tall); y <= my + tall; ++y) {
      context.moveTo(0, this.pixel(0, y)[1]);
      context.lineTo(canvas.width, this.pixel(0, y)[1]);
    }
    context.stroke();
    context.fillStyle = INK;
    const left = canvas.width - 16 - scale;
    context.fillRect(left, canvas.height - 18, scale, 3);
    context.font = `${12 * Math.min(2, window.devicePixelRatio)}px sans-serif`;
    context.fillText('1 m', left, canvas.height - 24);
  }

  /** @param {number[][]} points @param {string} colour @param {number} width @param {number[]} dash */
  stroke(points, colour, width, dash) {
    if (points.length < 2) return;
    const { context } = this;
    context.beginPath();
    points.forEach(([x, y], i) =>
      i === 0 ? context.moveTo(...this.pixel(x, y)) : context.lineTo(...this.pixel(x, y)),
    );
    context.setLineDash(dash);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
    context.setLineDash([]);
  }

  /**
   * The outline of a body's boxes from above.
   * @param {number} body
   * @param {number[]} pose
   * @param {string} colour
   * @param {boolean} filled
   */
  drawBody(body, pose, colour, filled) {
    for (const corners of this.corners.get(body) ?? []) {
      const hull = convexHull(
        corners.map((/** @type {number[]} */ p) => {
          const at = turned(pose.slice(3), p);
          return [at[0] + pose[0], at[1] + pose[1]];
        }),
      );
      const { context } = this;
      context.beginPath();
      hull.forEach(([x, y], i) =>
        i === 0 ? context.moveTo(...this.pixel(x, y)) : context.lineTo(...this.pixel(x, y)),
      );
      context.closePath();
      context.setLineDash(filled ? [] : [5, 4]);
      context.strokeStyle = context.fillStyle = colour;
      context.lineWidth = 1.5;
      if (filled) {
        context.globalAlpha = 0.25;
        context.fill();
      }
      context.globalAlpha = 1;
      context.stroke();
      context.setLineDash([]);
    }
  }

  dispose() {}

  framed() {
    return null;
  }

  framedNear() {
    const point = this.tracks.nearPoint(this.time);
    if (!point) return null;
    const [u, v] = this.pixel(point[0], point[1]);
    return [(2 * u) / this.canvas.width - 1, 1 - (2 * v) / this.canvas.height, null];
  }

  drawn() {
    return Object.fromEntries(
      [...(this.poses ?? [])].map(([body, pose]) => [this.tracks.scene.bodies[body].name, pose]),
    );
  }
}
