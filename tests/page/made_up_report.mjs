// A whole made-up report with any number of runs.
import { BlobStore } from './payload_writer.mjs';
import {
  MEANINGS,
  OUTCOMES,
  SOILS,
  columnMeanings,
  counts,
  interval,
  makeRows,
  table,
} from './made_up_rows.mjs';
import { makeReplay } from './made_up_run.mjs';
import { box, wheel } from './shapes.mjs';

/**
 * @param {{rows: number, replays?: number, single?: boolean, pictures?: boolean, bare?: boolean, images?: boolean,
 *   straight?: boolean}} options
 * `images`: of a controller that reports no sighting; `straight`: every start lies on the target's axis
 * @returns {{header: any, blobs: BlobStore, last: Map<number, number[]>}} `last`: last pose in W of the robot's body by run
 */
export function makeReport(options) {
  const { rows, replays = 0, single = false, pictures = true, bare = false, images = false } = options;
  const blobs = new BlobStore(),
    data = makeRows(rows);
  if (options.straight) data.start_y_m.fill(1e-16);
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
        success: data.outcome[row] === 0,
        start: [data.start_x_m[row], data.start_y_m[row], data.start_heading_rad[row]],
        duration_s: 60 + data.sim_time_s[row] / 10,
        images,
      },
      pictures,
    );
    header.replays.push(made.replay);
    last.set(data.run[row], made.last);
  }
  return { header, blobs, last };
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
              successes = Math.round(runs * (0.95 - (0.03 * Math.abs(i - 3)) / (d + 1)));
            return {
              label,
              word: label === 'soil' ? SOILS[i] : '',
              low: 2 + i / 4,
              high: 2.25 + i / 4,
              successes,
              runs,
              interval: interval(successes, runs),
            };
          }),
        ),
      },
    ],
    curves: [
      {
        x: 'start.r_m',
        measure: 'success',
        unit: '',
        by: 'soil',
        where: '',
        curves: SOILS.map((name, i) => ({
          name,
          points: [2, 3.5, 5.5, 7].map((x, k) => ({
            x,
            runs: 10,
            value: 1 - 0.1 * k - 0.05 * i,
            low: 0.8 - 0.15 * k,
            high: 1 - 0.05 * k,
          })),
        })),
      },
    ],
    aims: [{ text: 'success >= 0.9', share: 0.9 }],
    requirements: [{ met: false, text: 'not met: success >= 0.9, found 0.85 (34/40)' }],
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
