// One run over time: unpacks a replay of the data and answers for any time.

import { readChannel } from '../channels.js';
import { between, compose, inverse, moved, planarBetween } from './poses.js';

/** @typedef {import('./poses.js').Pose} Pose */
/** @typedef {import('./poses.js').Planar} Planar */

export class Tracks {
  /** @param {any} replay @param {any} scene @param {import('../payload.js').Blobs} blobs */
  constructor(replay, scene, blobs) {
    this.replay = replay;
    this.scene = scene;
    this.blobs = blobs;
    this.samples = replay.samples;
    this.period_s = replay.period_s;
    this.end_s = replay.end_s ?? (this.samples - 1) * this.period_s;
    const read = (/** @type {any} */ channel) => readChannel(blobs, channel, this.samples);
    this.bodies = (replay.bodies ?? []).map((/** @type {any} */ b) => ({
      body: b.body,
      pose: b.pose ?? null,
      track: b.track ? b.track.map(read) : null,
    }));
    this.X_WD = /** @type {Planar} */ (replay.X_WD ?? [0, 0, 0]);
    this.truth = replay.pose ? replay.pose.map(read) : null;
    this.believed = replay.believed ? replay.believed.pose.map(read) : null;
    this.located = replay.believed?.located ? read(replay.believed.located) : null;
    this.lines = (replay.lines ?? []).map((/** @type {any} */ line) => readLine(line, blobs, this.samples));
    this.plans = replay.plans ?? [];
    this.sightings = replay.sightings ?? [];
    this.images = replay.images?.shown ?? []; // without a sighting
    this.phases = replay.phases ?? [];
    this.ground = replay.ground ?? null;
    this.near = replay.near ? { at: replay.near.at.map(read), out: replay.near.out } : null;
  }

  /** Time of a sample. @param {number} sample */
  timeOf(sample) {
    return sample >= this.samples - 1 ? this.end_s : sample * this.period_s;
  }

  /** The sample at or before a time, and the share of the way to the next. @param {number} time */
  place(time) {
    if (time >= this.end_s || this.samples < 2) return { sample: this.samples - 1, share: 0 };
    const sample = Math.max(0, Math.min(this.samples - 2, Math.floor(time / this.period_s + 1e-9)));
    const begin = this.timeOf(sample);
    const share = (time - begin) / (this.timeOf(sample + 1) - begin);
    return { sample, share: Math.min(1, Math.max(0, share)) };
  }

  /**
   * Poses in W of all bodies that are drawn, by the body's index.
   * @param {number} time
   * @returns {Map<number, Pose>}
   */
  poses(time) {
    const { sample, share } = this.place(time);
    const poses = new Map();
    for (const { body, pose, track } of this.bodies) {
      if (!track) {
        poses.set(body, pose);
        continue;
      }
      const at = (/** @type {number} */ k) => track.map((/** @type {Float64Array} */ values) => values[k]);
      poses.set(
        body,
        share > 0 ? between(at(sample), at(sample + 1), share) : between(at(sample), at(sample), 0),
      );
    }
    return poses;
  }

  /** The target's point in W; null where the data have none. @param {number} time */
  nearPoint(time) {
    if (!this.near) return null;
    const { sample, share } = this.place(time);
    return this.near.at.map(
      (/** @type {Float64Array} */ values) =>
        values[sample] + (share > 0 ? share * (values[sample + 1] - values[sample]) : 0),
    );
  }

  /** True pose of the robot in D. @param {number} time @returns {Planar | null} */
  truePose(time) {
    return this.truth && this.planar(this.truth, time);
  }

  /**
   * What the controller believes, in D; null before it means anything.
   * @param {number} time
   * @returns {Planar | null}
   */
  believedPose(time) {
    if (!this.believed || !this.isLocated(this.place(time).sample)) return null;
    return this.planar(this.believed, time);
  }

  /** @param {number} sample */
  isLocated(sample) {
    return (
      Boolean(this.believed) &&
      (!this.located || this.located[sample] === 1) &&
      !Number.isNaN(this.believed[0][sample])
    );
  }

  /** @param {Float64Array[]} channels @param {number} time @returns {Planar | null} */
  planar(channels, time) {
    const { sample, share } = this.place(time);
    const at = (/** @type {number} */ k) => channels.map((values) => values[k]);
    const pose = share > 0 ? planarBetween(at(sample), at(sample + 1), share) : at(sample);
    return pose.some(Number.isNaN) ? null : pose;
  }

  /**
   * Poses in W of the robot's bodies where the controller believes them.
   * @param {number} time
   * @returns {Map<number, Pose> | null}
   */
  ghost(time) {
    const truth = this.truePose(time),
      believed = this.believedPose(time);
    if (!truth || !believed) return null;
    const shift = compose(compose(this.X_WD, compose(believed, inverse(truth))), inverse(this.X_WD));
    const poses = new Map();
    for (const [body, pose] of this.poses(time)) {
      if (this.scene.bodies[body].robot) poses.set(body, moved(shift, pose));
    }
    return poses;
  }

  /**
   * The way in W up to a time, true or believed, with the sample of each point.
   * @param {'truth' | 'believed'} which
   * @param {number} time
   */
  trail(which, time) {
    const channels = which === 'truth' ? this.truth : this.believed;
    /** @type {number[][]} */
    const points = [];
    /** @type {number[]} */
    const samples = [];
    if (!channels) return { points, samples };
    const last = this.place(time).sample;
    for (let k = 0; k <= last; ++k) {
      if ((which === 'believed' && !this.isLocated(k)) || Number.isNaN(channels[0][k])) continue;
      points.push(compose(this.X_WD, [channels[0][k], channels[1][k], 0]));
      samples.push(k);
    }
    return { points, samples };
  }

  /**
   * The last entry of a list that began at or before a time: a plan, a sighting.
   * @param {any[]} list
   * @param {number} time
   */
  latest(list, time) {
    const { sample } = this.place(time);
    let found = -1;
    for (let i = 0; i < list.length && list[i].sample <= sample; ++i) found = i;
    return found;
  }

  /** @param {number} time */
  phase(time) {
    const { sample } = this.place(time);
    let name = '';
    for (const [begin, text] of this.phases) if (begin <= sample) name = text;
    return name;
  }

  /** Points in W of a line. @param {any} line @param {number} time @returns {number[][]} */
  linePoints(line, time) {
    const { sample, share } = this.place(time);
    const at = (/** @type {number} */ k) => {
      const points = [];
      for (let i = line.begins[k]; i < line.begins[k + 1]; ++i)
        points.push([line.x[i], line.y[i], line.z[i]]);
      return points;
    };
    const now = at(sample);
    if (share === 0) return now;
    const next = at(sample + 1);
    if (next.length !== now.length) return now;
    return now.map((p, i) => p.map((v, axis) => v + share * (next[i][axis] - v)));
  }

  /** Box of robot and target over the run, in W: [x0, y0, x1, y1]. */
  extent() {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const take = (/** @type {number} */ x, /** @type {number} */ y) => {
      if (Number.isNaN(x) || Number.isNaN(y)) return;
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    };
    for (const { body, pose, track } of this.bodies) {
      if (this.scene.bodies[body].about) continue;
      if (!track) take(pose[0], pose[1]);
      else for (let k = 0; k < this.samples; k += 5) take(track[0][k], track[1][k]);
    }
    return Number.isFinite(box[0]) ? box : [-1, -1, 1, 1];
  }
}

/** @param {any} line @param {import('../payload.js').Blobs} blobs @param {number} samples */
function readLine(line, blobs, samples) {
  const counts = readChannel(blobs, line.counts, samples);
  const begins = new Uint32Array(samples + 1);
  for (let k = 0; k < samples; ++k) begins[k + 1] = begins[k] + counts[k];
  const [x, y, z] = line.points.map((/** @type {any} */ channel) =>
    readChannel(blobs, channel, begins[samples]),
  );
  return { name: line.name, diameter_m: line.diameter_m, colour: line.colour, begins, x, y, z };
}
