// The first pose of the camera: all of robot and target in view, over the whole run.

import { Box3, Matrix4, Quaternion, Vector3 } from 'three';

const ASIDE = 1.0; // rad off the target's axis: neither hides the other
const ABOVE = 0.27; // rad
const FILLED = 0.86; // share of the image
const NEAREST_M = 1;
const SAMPLES = 40; // poses that are tried

/**
 * Corners in W of the boxes round robot and target, over the run.
 * @param {import('./tracks.js').Tracks} tracks
 * @param {Map<number, any>} groups the bodies as they are drawn
 * @returns {Vector3[]}
 */
export function cornersOf(tracks, groups) {
  const boxes = new Map();
  for (const [body, group] of groups) {
    if (tracks.scene.bodies[body].about) continue;
    group.position.set(0, 0, 0);
    group.quaternion.identity();
    group.updateMatrixWorld(true);
    const box = new Box3().setFromObject(group);
    if (!box.isEmpty()) boxes.set(body, box);
  }
  const corners = [];
  for (let i = 0; i <= SAMPLES; ++i) {
    for (const [body, pose] of tracks.poses((tracks.end_s * i) / SAMPLES)) {
      const box = boxes.get(body);
      if (!box || !pose || pose.some(Number.isNaN)) continue;
      const matrix = new Matrix4().compose(
        new Vector3(pose[0], pose[1], pose[2]),
        new Quaternion(pose[3], pose[4], pose[5], pose[6]),
        new Vector3(1, 1, 1),
      );
      for (let c = 0; c < 8; ++c) {
        const corner = new Vector3(
          c & 1 ? box.max.x : box.min.x,
          c & 2 ? box.max.y : box.min.y,
          c & 4 ? box.max.z : box.min.z,
        );
        corners.push(corner.applyMatrix4(matrix));
      }
    }
  }
  return corners;
}

/**
 * From the centre to the camera: before the target, aside of its axis, on the sun's side unless something
 * that throws a shadow is there.
 * @param {import('./tracks.js').Tracks} tracks
 */
function outwards(tracks) {
  const heading = tracks.X_WD[2];
  const [x, y] = tracks.scene.sun_W ?? [0, 0];
  const sunny = Math.sin(Math.atan2(y, x) - heading) >= 0 ? 1 : -1;
  const shaded = tracks.scene.bodies.some((/** @type {any} */ b) => b.name === 'shade' && !b.leaves);
  const azimuth = heading + (shaded ? -sunny : sunny) * ASIDE;
  return new Vector3(
    Math.cos(ABOVE) * Math.cos(azimuth),
    Math.cos(ABOVE) * Math.sin(azimuth),
    Math.sin(ABOVE),
  );
}

/**
 * The nearest place from which a camera sees all corners.
 * @param {import('./tracks.js').Tracks} tracks
 * @param {Vector3[]} corners
 * @param {number} fov of the image's height, in degrees
 * @param {number} aspect
 * @returns {{from: Vector3, centre: Vector3, distance: number}}
 */
export function firstView(tracks, corners, fov, aspect) {
  const out = outwards(tracks);
  const right = new Vector3(0, 0, 1).cross(out).normalize(),
    up = out.clone().cross(right);
  const high = FILLED * Math.tan((fov * Math.PI) / 360),
    wide = high * aspect;
  const centre = new Box3().setFromPoints(corners).getCenter(new Vector3());
  let distance = NEAREST_M;
  for (let turn = 0; turn < 4; ++turn) {
    distance = NEAREST_M;
    for (const corner of corners) {
      const p = corner.clone().sub(centre);
      const across = Math.max(Math.abs(p.dot(right)) / wide, Math.abs(p.dot(up)) / high);
      distance = Math.max(distance, p.dot(out) + across);
    }
    // Near things appear large: the image's middle is not that of the box.
    const ends = [Infinity, -Infinity, Infinity, -Infinity];
    for (const corner of corners) {
      const p = corner.clone().sub(centre);
      const u = p.dot(right) / (distance - p.dot(out)),
        v = p.dot(up) / (distance - p.dot(out));
      ends[0] = Math.min(ends[0], u);
      ends[1] = Math.max(ends[1], u);
      ends[2] = Math.min(ends[2], v);
      ends[3] = Math.max(ends[3], v);
    }
    if (turn === 3) break;
    centre.addScaledVector(right, (distance * (ends[0] + ends[1])) / 2);
    centre.addScaledVector(up, (distance * (ends[2] + ends[3])) / 2);
  }
  return { from: centre.clone().addScaledVector(out, distance), centre, distance };
}
