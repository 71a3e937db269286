// The table of a made-up report: runs with outcomes, factors and measures, and their counts.

export const OUTCOMES = ['docked', 'timeout', 'face_catch', 'false_docked'];
export const MEANINGS = [
  'the tip is seated, and the shake moves nothing',
  'time ran out with none of the above',
  'the tip has pressed on the flat face for 3 s',
  'the controller says docked, the truth says not docked',
];
export const SOILS = ['loose', 'compact'];
const LIGHTS = ['even', 'speckled', 'hard_shadow'];

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
export function interval(successes, runs) {
  const share = successes / runs,
    half = 1 / Math.sqrt(runs);
  return [Math.max(0, share - half), Math.min(1, share + half)];
}

export function makeRows(rows) {
  const random = randomFrom(7);
  const data = {
    run: new Int32Array(rows),
    outcome: new Uint8Array(rows),
    success: new Uint8Array(rows),
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
    data.success[i] = bad ? 0 : 1;
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

export function columnMeanings() {
  return [
    ['run', '', 'the run’s number'],
    ['success', '', 'whether the outcome is a success'],
    ['sim_time_s', 's', 'simulated time'],
    ['tip_depth_m', 'm', 'arm tip behind the plane of the mouth, at the end'],
    ['lateral_error_m', 'm', 'arm tip off the axis, at the end'],
    ['yaw_error_rad', 'rad', 'heading against the axis, at the end'],
    ['tension_peak_n', 'N', 'largest tension of the tether'],
    ['spool_current_peak_a', 'A', 'of the spool’s motor'],
    ['station_shift_m', 'm', 'mouth from where it stood'],
  ].map(([name, unit, meaning]) => ({ name, unit, meaning }));
}

export function table(blobs, data) {
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
export function counts(data) {
  const rows = data.run.length,
    successes = data.success.reduce((sum, v) => sum + v, 0);
  const by = (codes, names, label) => ({
    label,
    values: names
      .map((value, code) => {
        let runs = 0,
          good = 0;
        for (let i = 0; i < rows; ++i)
          if (codes[i] === code) {
            ++runs;
            good += data.success[i];
          }
        return { value, successes: good, runs, interval: interval(good, Math.max(1, runs)) };
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
    totals: { runs: rows, planned: rows, successes, word: 'docked', interval: interval(successes, rows), lost: 0 },
    groups: rows > 1 ? [by(data.soil, SOILS, 'soil'), by(data.light, LIGHTS, 'light')] : [],
    causes,
  };
}
