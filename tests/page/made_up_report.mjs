// A whole made-up report with any number of runs.
import { BlobStore } from './payload_writer.mjs';
import { makeReplay } from './made_up_run.mjs';
import { box, wheel } from './shapes.mjs';

const OUTCOMES = ['docked', 'timeout', 'face_catch', 'false_docked'];
const MEANINGS = [
  'the tip is seated, and the shake moves nothing',
  'time ran out with none of the above',
  'the tip has pressed on the flat face for 3 s',
  'the controller says docked, the truth says not docked',
];
const SOILS = ['loose', 'compact'],
  LIGHTS = ['even', 'speckled', 'hard_shadow'];

/** Numbers that look random and are the same each time. */
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A stand-in for an exact interval: the page must show what it is given. */
function interval(docked, runs) {
  const share = docked / runs,
    half = 1 / Math.sqrt(runs);
  return [Math.max(0, share - half), Math.min(1, share + half)];
}

/**
 * @param {{rows: number, replays?: number, single?: boolean, pictures?: boolean, bare?: boolean}} options
 * @returns {{header: any, blobs: BlobStore, last: Map<number, number[]>}} `last`: last pose in W of the robot's body by run
 */
export function makeReport({ rows, replays = 0, single = false, pictures = true, bare = false }) {
  const blobs = new BlobStore(),
    data = makeRows(rows);
  const header = {
    format: 1,
    title: single ? 'A made-up run' : 'Made-up campaign',
    program: 'dockyard 0.0 (made up)',
    campaign: single
      ? null
      : { name: 'made_up', seed: '17', planned: rows, design: 'monte_carlo', file: 'campaign.yaml' },
    system: {
      name: 'made_up',
      outcomes: OUTCOMES.map((name, i) => ({ name, success: i === 0, meaning: MEANINGS[i] })),
      columns: columnMeanings(),
    },
    ...counts(data),
    sensitivity: [],
    arms: [],
    acceptance: null,
    table: table(blobs, data),
    scenes: [],
    meshes: [],
    replays: [],
    left_out: [],
  };
  if (!single && !bare)
    Object.assign(header, comparisons(rows), {
      left_out: ['Replays of the runs after the first ones: the file would have passed 50 MB.'],
    });
  header.worst = [{ column: 'lateral_error_m', largest: true }];
  header.replay_command = 'dockyard replay out/made_up {run}';
  const last = new Map();
  if (replays > 0) addScene(header, blobs);
  for (let row = 0; row < Math.min(rows, replays); ++row) {
    const made = makeReplay(
      blobs,
      {
        run: data.run[row],
        outcome: OUTCOMES[data.outcome[row]],
        docked: data.outcome[row] === 0,
        start: [data.start_x_m[row], data.start_y_m[row], data.start_heading_rad[row]],
        duration_s: 60 + data.sim_time_s[row] / 10,
      },
      pictures,
    );
    header.replays.push(made.replay);
    last.set(data.run[row], made.last);
  }
  return { header, blobs, last };
}

function makeRows(rows) {
  const random = randomFrom(7);
  const data = {
    run: new Int32Array(rows),
    outcome: new Uint8Array(rows),
    docked: new Uint8Array(rows),
    soil: new Uint8Array(rows),
    light: new Uint8Array(rows),
  };
  for (const name of [
    'sim_time_s',
    'tip_depth_m',
    'lateral_error_m',
    'yaw_error_rad',
    'start_x_m',
    'start_y_m',
    'start_heading_rad',
    'cpu_time_s',
    'wall_time_s',
    'tension_peak_n',
    'spool_current_peak_a',
    'station_shift_m',
  ])
    data[name] = new Float32Array(rows);
  for (let i = 0; i < rows; ++i) {
    const alpha = (random() - 0.5) * 0.7,
      range = 2 + 2 * random();
    data.run[i] = i + 1;
    data.soil[i] = i & 1;
    data.light[i] = Math.floor(3 * random());
    const bad = random() < 0.06 + 0.1 * Math.abs(alpha) + (data.light[i] === 2 ? 0.08 : 0);
    data.outcome[i] = bad ? 1 + Math.floor(3 * random()) : 0;
    data.docked[i] = bad ? 0 : 1;
    data.start_x_m[i] = range * Math.cos(alpha);
    data.start_y_m[i] = range * Math.sin(alpha);
    data.start_heading_rad[i] = Math.PI + (random() - 0.5) * 0.5;
    data.sim_time_s[i] = bad ? 150 + 50 * random() : 45 + 60 * random();
    data.tip_depth_m[i] = bad ? (data.outcome[i] === 1 ? NaN : 0.2 * random()) : 0.24 + 0.03 * random();
    data.lateral_error_m[i] = (bad ? 0.02 : 0.002) * random();
    data.yaw_error_rad[i] = (random() + random() - 1) * (bad ? 0.1 : 0.03);
    data.tension_peak_n[i] = 180 + 140 * random() * random();
    data.spool_current_peak_a[i] = 0.8 + 1.2 * random();
    data.station_shift_m[i] = 0.004 * random() ** 3;
    data.cpu_time_s[i] = data.sim_time_s[i] / 30 + random();
    data.wall_time_s[i] = data.cpu_time_s[i] * 1.1;
  }
  return data;
}

function columnMeanings() {
  return [
    ['run', '', 'the run’s number'],
    ['docked', '', 'whether the outcome is a success'],
    ['sim_time_s', 's', 'simulated time'],
    ['tip_depth_m', 'm', 'arm tip behind the plane of the mouth, at the end'],
    ['lateral_error_m', 'm', 'arm tip off the axis, at the end'],
    ['yaw_error_rad', 'rad', 'heading against the axis, at the end'],
    ['tension_peak_n', 'N', 'largest tension of the tether'],
    ['spool_current_peak_a', 'A', 'of the spool’s motor'],
    ['station_shift_m', 'm', 'mouth from where it stood'],
  ].map(([name, unit, meaning]) => ({ name, unit, meaning }));
}

function table(blobs, data) {
  const dictionaries = { outcome: OUTCOMES, soil: SOILS, light: LIGHTS };
  const kinds = { Int32Array: 'i32', Uint8Array: 'u8', Float32Array: 'f32' };
  return {
    rows: data.run.length,
    columns: Object.entries(data).map(([name, values]) => ({
      name,
      unit: /_(s|m|rad|n|a)$/.exec(name)?.[1].replace('n', 'N').replace(/^a$/, 'A') ?? '',
      kind: kinds[values.constructor.name],
      ...(dictionaries[name] ? { dictionary: dictionaries[name] } : {}),
      blob: blobs.add(values),
    })),
  };
}

/** Totals, success by factor, causes: counted here as the program would. */
function counts(data) {
  const rows = data.run.length,
    docked = data.docked.reduce((sum, v) => sum + v, 0);
  const by = (codes, names, label) => ({
    label,
    values: names
      .map((value, code) => {
        let runs = 0,
          good = 0;
        for (let i = 0; i < rows; ++i)
          if (codes[i] === code) {
            ++runs;
            good += data.docked[i];
          }
        return { value, docked: good, runs, interval: interval(good, Math.max(1, runs)) };
      })
      .filter((value) => value.runs > 0),
  });
  const causes = OUTCOMES.slice(1)
    .map((outcome, k) => {
      const runs = [];
      let count = 0;
      for (let i = 0; i < rows; ++i) if (data.outcome[i] === k + 1 && ++count <= 10) runs.push(data.run[i]);
      return { outcome, count, runs };
    })
    .filter((cause) => cause.count > 0)
    .sort((a, b) => b.count - a.count);
  return {
    totals: { runs: rows, planned: rows, docked, interval: interval(docked, rows), lost: 0 },
    groups: rows > 1 ? [by(data.soil, SOILS, 'soil'), by(data.light, LIGHTS, 'light')] : [],
    causes,
  };
}

function comparisons(rows) {
  const draws = [
    'start.r_m',
    'start.alpha_deg',
    'station: cone.funnel_friction',
    'sun.elevation_deg',
    'soil',
  ];
  return {
    sensitivity: [
      {
        arm: '',
        draws: draws.map((label, i) => ({
          label,
          words: label === 'soil',
          eta: 0.42 / (i + 1),
          p: 0.0004 * 10 ** i,
          rank:
            label === 'soil'
              ? null
              : {
                  value: ((i % 2 ? -1 : 1) * 0.4) / (i + 1),
                  low: ((i % 2 ? -1 : 1) * 0.4) / (i + 1) - 0.15,
                  high: ((i % 2 ? -1 : 1) * 0.4) / (i + 1) + 0.15,
                },
          partial: null,
        })),
        levels: draws.flatMap((label, d) =>
          Array.from({ length: label === 'soil' ? 2 : 8 }, (_, i) => {
            const runs = Math.ceil(rows / 8),
              docked = Math.round(runs * (0.95 - (0.03 * Math.abs(i - 3)) / (d + 1)));
            return {
              label,
              word: label === 'soil' ? SOILS[i] : '',
              low: 2 + i / 4,
              high: 2.25 + i / 4,
              docked,
              runs,
              interval: interval(docked, runs),
            };
          }),
        ),
      },
    ],
    arms: [
      {
        a: 'ours',
        b: 'tsai2013',
        both: 31,
        only_a: 5,
        only_b: 1,
        neither: 3,
        difference: 0.1,
        interval: [-0.01, 0.22],
        exact_p: 0.22,
        mid_p: 0.13,
      },
    ],
    acceptance: {
      verdict: 'Undecided',
      sentence: '36 of 40 docked do not yet show a reliability of 90 %.',
      reliability: 0.9,
      confidence: 0.95,
      lower: 0.786,
      upper: 0.965,
      further_runs: 37,
    },
  };
}

function addScene(header, blobs) {
  const mesh = ({ vertices, triangles }) =>
    header.meshes.push({
      vertices: blobs.add(Float32Array.from(vertices)),
      triangles: blobs.add(Uint32Array.from(triangles)),
    }) - 1;
  const part = (index, colour) => ({ mesh: index, position: [0, 0, 0], quaternion: [0, 0, 0, 1], colour });
  const station = mesh(box(0.3, 0.45, 0.32, [-0.35, 0, 0.4])),
    hull = mesh(box(0.14, 0.26, 0.12)),
    arm = mesh(box(0.5, 0.02, 0.02, [0.5, 0, 0]));
  const round = mesh(wheel(0.27, 0.14));
  header.scenes.push({
    sun_W: [0.5, -0.5, 0.7],
    bodies: [
      { name: 'station', robot: false, parts: [part(station, [0.21, 0.2, 0.17])] },
      { name: 'body', robot: true, parts: [part(hull, [0.27, 0.22, 0.15]), part(arm, [0.17, 0.17, 0.18])] },
      { name: 'left wheel', robot: true, parts: [part(round, [0.08, 0.08, 0.09])] },
      { name: 'right wheel', robot: true, parts: [part(round, [0.08, 0.08, 0.09])] },
    ],
    board: {
      body: 0,
      position: [-0.04, 0, 0.47],
      quaternion: [0.5, 0.5, -0.5, -0.5],
      width_m: 0.9,
      height_m: 0.5,
      discs: [
        [-0.36, -0.17, 0],
        [-0.12, -0.18, 45],
        [0.14, -0.17, 90],
        [0.37, -0.16, -45],
        [-0.38, 0.06, 90],
        [-0.27, 0.18, -45],
        [0.27, 0.04, 0],
        [0.37, 0.17, 45],
      ].map(([x, y, turn]) => ({
        x,
        y,
        radius: 0.05,
        bar: { length: 0.064, width: 0.022, turn: (turn * Math.PI) / 180 },
      })),
      holes: [{ x: 0, y: 0.1, radius: 0.12 }],
    },
  });
}
