// Poses as [x, y, z, qx, qy, qz, qw] and planar ones as [x, y, heading].

/** @typedef {number[]} Pose */
/** @typedef {number[]} Planar */

/**
 * The pose between two: straight, and by the shorter turn.
 * @param {Pose} a @param {Pose} b @param {number} share @returns {Pose}
 */
export function between(a, b, share) {
  const pose = [0, 1, 2].map((i) => a[i] + share * (b[i] - a[i]));
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const turn = [3, 4, 5, 6].map((i) => a[i] + share * (sign * b[i] - a[i]));
  const size = Math.hypot(...turn) || 1;
  return [...pose, ...turn.map((v) => v / size)];
}

/** @param {Planar} a @param {Planar} b @param {number} share @returns {Planar} */
export function planarBetween(a, b, share) {
  const turn = Math.atan2(Math.sin(b[2] - a[2]), Math.cos(b[2] - a[2]));
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * turn];
}

/** @param {Planar} X_AB @param {Planar} X_BC @returns {Planar} */
export function compose(X_AB, X_BC) {
  const c = Math.cos(X_AB[2]),
    s = Math.sin(X_AB[2]);
  return [X_AB[0] + c * X_BC[0] - s * X_BC[1], X_AB[1] + s * X_BC[0] + c * X_BC[1], X_AB[2] + X_BC[2]];
}

/** @param {Planar} X_AB @returns {Planar} */
export function inverse(X_AB) {
  const c = Math.cos(X_AB[2]),
    s = Math.sin(X_AB[2]);
  return [-c * X_AB[0] - s * X_AB[1], s * X_AB[0] - c * X_AB[1], -X_AB[2]];
}

/** A planar motion applied to a pose in space. @param {Planar} X_AB @param {Pose} pose @returns {Pose} */
export function moved(X_AB, pose) {
  const c = Math.cos(X_AB[2]),
    s = Math.sin(X_AB[2]);
  const [half_s, half_c] = [Math.sin(X_AB[2] / 2), Math.cos(X_AB[2] / 2)];
  const [x, y, z, qx, qy, qz, qw] = pose;
  return [
    X_AB[0] + c * x - s * y,
    X_AB[1] + s * x + c * y,
    z,
    half_c * qx - half_s * qy,
    half_c * qy + half_s * qx,
    half_c * qz + half_s * qw,
    half_c * qw - half_s * qz,
  ];
}

/** A point turned by a quaternion. @param {number[]} q x, y, z, w @param {number[]} p @returns {number[]} */
export function turned(q, p) {
  const [x, y, z, w] = q;
  const tx = 2 * (y * p[2] - z * p[1]),
    ty = 2 * (z * p[0] - x * p[2]),
    tz = 2 * (x * p[1] - y * p[0]);
  return [p[0] + w * tx + y * tz - z * ty, p[1] + w * ty + z * tx - x * tz, p[2] + w * tz + x * ty - y * tx];
}
