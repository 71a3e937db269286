// The replay of a made-up run: a rover with two wheels drives to a station, leaves ruts, draws a tether.
import { picture } from './shapes.mjs';

const AXLE_M = 0.27,
  HALF_TRACK_M = 0.35,
  CELL_M = 0.04;
export const X_WD = [1.0, 0.5, 0.3];

const pictures = new Map(); // by their discs: runs share them

function storedPicture(discs) {
  const key = discs.join();
  if (!pictures.has(key)) pictures.set(key, picture(512, 384, discs));
  return pictures.get(key);
}

/** @param {number[]} a @param {number[]} b */
function compose(a, b) {
  const [c, s] = [Math.cos(a[2]), Math.sin(a[2])];
  return [a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]];
}

/** Quaternion of a heading followed by a turn about the body's y. */
function yawPitch(yaw, pitch) {
  const [sy, cy, sp, cp] = [Math.sin(yaw / 2), Math.cos(yaw / 2), Math.sin(pitch / 2), Math.cos(pitch / 2)];
  return [-sy * sp, cy * sp, sy * cp, cy * cp];
}

/** Poses in D over the run: from the start to the station along an eased line with a swing. */
function drive(start, samples) {
  return Array.from({ length: samples }, (_, k) => {
    const s = k / (samples - 1),
      eased = s * s * (3 - 2 * s);
    const x = start[0] + (0.92 - start[0]) * eased,
      y = start[1] * (1 - eased) ** 2;
    const slope = (-2 * start[1] * (1 - eased)) / (0.92 - start[0]);
    return [x, y, Math.PI + Math.atan(slope) + (start[2] - Math.PI) * (1 - eased) ** 3];
  });
}

/**
 * @param {import('./payload_writer.mjs').BlobStore} blobs
 * @param {{run: number, outcome: string, success: boolean, start: number[], duration_s: number}} run
 * @returns {{replay: object, last: number[]}} with the last pose of the body in W, as it was before packing
 */
export function makeReplay(blobs, run, with_pictures = true) {
  const period_s = 0.1,
    samples = Math.round(run.duration_s / period_s) + 1;
  const poses_D = drive(run.start, samples),
    poses_W = poses_D.map((pose) => compose(X_WD, pose));
  let rolled = 0;
  const turns = poses_W.map((pose, k) => {
    if (k > 0) rolled += Math.hypot(pose[0] - poses_W[k - 1][0], pose[1] - poses_W[k - 1][1]) / AXLE_M;
    return rolled;
  });
  const bounce = poses_W.map((_, k) => AXLE_M + 0.004 * Math.sin(k / 3));
  const body = poses_W.map((pose, k) => [
    pose[0],
    pose[1],
    bounce[k],
    ...yawPitch(pose[2], 0.02 * Math.sin(k / 7)),
  ]);
  const wheelAt = (side) =>
    poses_W.map((pose, k) => [
      pose[0] - side * HALF_TRACK_M * Math.sin(pose[2]),
      pose[1] + side * HALF_TRACK_M * Math.cos(pose[2]),
      bounce[k],
      ...yawPitch(pose[2], turns[k]),
    ]);
  const track = (poses) =>
    Array.from({ length: 7 }, (_, i) =>
      blobs.channel(
        poses.map((p) => p[i]),
        i < 3 ? 1e-4 : 1e-4,
      ),
    );
  const end_s = (samples - 1) * period_s - 0.04;
  const planar = (poses) =>
    [0, 1, 2].map((i) =>
      blobs.channel(
        poses.map((p) => p[i]),
        1e-4,
      ),
    );
  const believed = poses_D.map((pose, k) =>
    k < 30 ? [NaN, NaN, NaN] : [pose[0] + 0.03 * Math.cos(k / 40), pose[1] + 0.02, pose[2] + 0.01],
  );
  const replay = {
    run: run.run,
    scene: 0,
    title: `Run ${run.run}`,
    outcome: run.outcome,
    success: run.success,
    sentence: run.success
      ? 'Tip 243 mm deep; the shake moved it by 2.1 mm.'
      : 'The tip rests 41 mm short of the socket, and the controller says docked.',
    command: `dockyard replay out/made_up ${run.run}`,
    seed: '11446999876264359965',
    state_hash: '5098a6a7dd9cc2e1',
    samples,
    period_s,
    end_s,
    X_WD,
    bodies: [
      { body: 0, pose: [X_WD[0], X_WD[1], 0, ...yawPitch(X_WD[2], 0)] },
      { body: 1, track: track(body) },
      { body: 2, track: track(wheelAt(1)) },
      { body: 3, track: track(wheelAt(-1)) },
    ],
    lines: [tether(blobs, body, samples)],
    ground: ground(blobs, wheelAt(1), wheelAt(-1), samples),
    near: near(blobs, body),
    pose: planar(poses_D),
    believed: {
      pose: planar(believed),
      located: blobs.channel(
        believed.map((p) => (Number.isNaN(p[0]) ? 0 : 1)),
        1,
      ),
    },
    plans: [0.1, 0.55].map((share) => ({
      sample: Math.round(share * samples),
      points: poses_D
        .slice(Math.round(share * samples))
        .filter((_, i) => i % 8 === 0)
        .map(([x, y]) => [x, y + 0.03]),
    })),
    sightings: run.images ? [] : sightings(blobs, run, poses_D, samples, with_pictures),
    images: run.images ? { taken: 200, shown: images(blobs, samples) } : null,
    scalars: scalars(blobs, samples, rolled),
    phases: [
      [0, 'tighten'],
      [Math.round(samples * 0.1), 'sight'],
      [Math.round(samples * 0.2), 'drive'],
      [Math.round(samples * 0.7), 'reel in'],
      [Math.round(samples * 0.95), 'seat'],
    ],
    messages: run.run % 7 === 0 ? 'warning: the left motor was at its limit for 0.3 s\n' : '',
  };
  return { replay, last: body[samples - 1] };
}

/** The target's point: over the station, and in the second half of the run taken along by the robot. */
function nearPoints(body) {
  const half = Math.floor(body.length / 2);
  return body.map((pose, k) => {
    const moved = k <= half ? [0, 0, 0] : [0, 1, 2].map((i) => pose[i] - body[half][i]);
    return [X_WD[0] + moved[0], X_WD[1] + moved[1], 0.34 + moved[2]];
  });
}

export const NEAR_OUT = [0.3, -0.5, 0.4];

function near(blobs, body) {
  const points = nearPoints(body);
  return {
    at: [0, 1, 2].map((axis) =>
      blobs.channel(
        points.map((p) => p[axis]),
        1e-4,
      ),
    ),
    out: NEAR_OUT,
  };
}

function tether(blobs, body, samples) {
  const counts = [],
    points = [];
  for (let k = 0; k < samples; ++k) {
    const sag = 0.25 * (1 - k / samples),
      [x, y, z] = body[k],
      count = k < samples / 2 ? 9 : 5;
    counts.push(count);
    for (let i = 0; i < count; ++i) {
      const s = i / (count - 1);
      points.push([
        x + s * (X_WD[0] - x),
        y + s * (X_WD[1] - y),
        Math.max(0.01, z + s * (0.34 - z) - 4 * sag * s * (1 - s)),
      ]);
    }
  }
  return {
    name: 'tether',
    diameter_m: 0.004,
    colour: [0.03, 0.03, 0.03],
    counts: blobs.channel(counts, 1),
    points: [0, 1, 2].map((axis) =>
      blobs.channel(
        points.map((p) => p[axis]),
        1e-3,
      ),
    ),
  };
}

const HEIGHT_QUANTUM_M = 0.0001;
const metres = (steps) => Float64Array.from(steps, (step) => step * HEIGHT_QUANTUM_M);

function ground(blobs, left, right, samples) {
  const columns = 120,
    rows = 90,
    x0_m = -0.6,
    y0_m = -1.0;
  const heights = Int16Array.from(
    { length: columns * rows },
    (_, i) => 120 * Math.sin((i % columns) / 9) * Math.cos(Math.floor(i / columns) / 7),
  );
  const changes = [];
  const now = heights.slice();
  for (let begin = 0; begin < samples; begin += 20) {
    const changed = new Set();
    for (let k = begin; k < Math.min(samples, begin + 20); ++k) {
      for (const [x, y] of [left[k], right[k]]) {
        for (let dy = -2; dy <= 2; ++dy)
          for (let dx = -2; dx <= 2; ++dx) {
            const column = Math.round((x - x0_m) / CELL_M) + dx,
              row = Math.round((y - y0_m) / CELL_M) + dy;
            if (column < 0 || row < 0 || column >= columns || row >= rows || dx * dx + dy * dy > 5) continue;
            const cell = row * columns + column;
            now[cell] = heights[cell] - 260 + 20 * (dx * dx + dy * dy);
            changed.add(cell);
          }
      }
    }
    const cells = Uint32Array.from([...changed].sort((a, b) => a - b));
    changes.push({
      sample: Math.min(samples - 1, begin + 19),
      cells: blobs.channel(cells, 1),
      heights: blobs.channel(metres(Int16Array.from(cells, (cell) => now[cell])), HEIGHT_QUANTUM_M),
    });
  }
  return { x0_m, y0_m, cell_m: CELL_M, columns, rows, heights: blobs.channel(metres(heights), HEIGHT_QUANTUM_M), changes };
}

/** Images of a controller that reports no sighting. */
function images(blobs, samples) {
  return Array.from({ length: 20 }, (_, n) => ({
    sample: Math.round((n * (samples - 1)) / 19),
    cameras: [
      { name: 'left', width: 1024, height: 768, picture: blobs.add(storedPicture([[100 + 10 * n, 120, 16]])) },
    ],
  }));
}

function sightings(blobs, run, poses_D, samples, with_pictures) {
  return [0.08, 0.3, 0.52, 0.66].map((share, n) => {
    const sample = Math.round(share * samples),
      pose = poses_D[sample],
      accepted = n !== 1;
    const cameras = ['left', 'right'].map((name, side) => {
      const discs = Array.from({ length: 8 }, (_, i) => [
        300 + n * 40 + 110 * (i % 4) - 30 * side,
        240 + 90 * Math.floor(i / 4) + 7 * (i % 3),
        16 + 3 * n,
      ]);
      const image = with_pictures ? blobs.add(storedPicture(discs.map((d) => d.map((v) => v / 2)))) : null;
      return {
        name,
        width: 1024,
        height: 768,
        picture: image,
        marks: discs.map(([u, v], i) => [u, v, i, i === 5 && !accepted ? 0 : 1]),
      };
    });
    return {
      sample,
      accepted,
      reason: accepted ? '' : 'three marks only',
      method: accepted ? 'stereo' : '',
      pose,
      measured: accepted ? [pose[0] + 0.008, pose[1] + 0.007, pose[2] + 0.006] : null,
      cameras,
      reprojection_px: accepted ? 0.11 : null,
    };
  });
}

function scalars(blobs, samples, rolled) {
  const wave = (size, period, phase = 0) =>
    Array.from({ length: samples }, (_, k) => size * Math.sin(k / period + phase) ** 2);
  const make = (name, unit, group, source, values, quantum) => ({
    name,
    unit,
    group,
    source,
    meaning: `the ${name.replaceAll('_', ' ')}`,
    channel: blobs.channel(values, quantum),
  });
  return [
    make('left_current_a', 'A', 'Motor currents', 'sensor', wave(1.8, 40), 0.01),
    make('right_current_a', 'A', 'Motor currents', 'sensor', wave(1.7, 37, 1), 0.01),
    make('spool_current_a', 'A', 'Motor currents', 'sensor', wave(1, 90), 0.01),
    make('tension_n', 'N', 'Forces', 'truth', wave(220, 120), 0.1),
    make(
      'cone_force_n',
      'N',
      'Forces',
      'truth',
      wave(60, 30).map((v, k) => (k > samples * 0.8 ? v : 0)),
      0.1,
    ),
    make('pitch_rad', 'rad', 'Attitude', 'truth', wave(0.05, 9), 1e-4),
    make('roll_rad', 'rad', 'Attitude', 'truth', wave(0.03, 14), 1e-4),
    make(
      'tether_length_m',
      'm',
      'Tether',
      'belief',
      wave(2, 200).map((v, k) => (k < 30 ? NaN : 3 - v / 2)),
      1e-3,
    ),
    make('left_sinkage_m', 'm', 'Sinkage', 'truth', wave(0.02, 25), 1e-4),
    make('turn_rad', 'rad', 'Wheels', 'truth', wave(rolled, 300), 1e-3),
  ];
}
