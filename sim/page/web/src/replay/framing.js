// Where things are in a camera's image: -1 to 1 across and upwards.

import { Vector3 } from 'three';

/**
 * The ends of all corners: [u0, v0, u1, v1].
 * @param {Vector3[]} corners in W
 * @param {any} camera
 */
export function framedCorners(corners, camera) {
  camera.updateMatrixWorld();
  const ends = [Infinity, Infinity, -Infinity, -Infinity];
  for (const corner of corners) {
    const { x, y } = corner.clone().project(camera);
    ends[0] = Math.min(ends[0], x);
    ends[1] = Math.min(ends[1], y);
    ends[2] = Math.max(ends[2], x);
    ends[3] = Math.max(ends[3], y);
  }
  return ends;
}

/**
 * A point, and how far from the camera it is in metres: [u, v, distance]; null without a point.
 * @param {number[] | null} point in W
 * @param {any} camera
 */
export function framedPoint(point, camera) {
  if (!point) return null;
  camera.updateMatrixWorld();
  const at = new Vector3(...point);
  const { x, y } = at.clone().project(camera);
  return [x, y, at.distanceTo(camera.position)];
}
