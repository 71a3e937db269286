// The report's page in a real browser, from disk and without network. Run by scripts/test-page.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { openReport, startBrowser } from './browser.mjs';
import { makeReport } from './made_up_report.mjs';
import { NEAR_OUT } from './made_up_run.mjs';
import { fillPage, packPayload, pageWith } from './payload_writer.mjs';

const folder = mkdtempSync(join(tmpdir(), 'report-'));
let browser, flat_browser;
before(async () => {
  browser = await startBrowser();
  flat_browser = await startBrowser(['--disable-3d-apis']);
});
after(async () => {
  await browser?.close();
  await flat_browser?.close();
  rmSync(folder, { recursive: true });
});

/** Writes a report and opens it. */
async function open(options, view = {}, with_browser = browser) {
  const report = makeReport(options);
  const file = join(folder, `${Object.values(options).join('-')}.html`);
  writeFileSync(file, pageWith(packPayload(report.header, report.blobs)));
  return { ...report, ...(await openReport(with_browser, file, view)) };
}

/** Opens a page with this text in the place of its data. */
async function openText(name, text) {
  const file = join(folder, `${name}.html`);
  writeFileSync(file, fillPage(text));
  return openReport(browser, file);
}

const frameOf = (page) => page.evaluate(() => window.report.frame());

test('nothing is printed on the console, and no file is asked for but the page', async () => {
  const { page, context, messages, requests } = await open({ rows: 40, replays: 3 });
  await page.click('button[aria-label="Open run 7"]');
  await page.goBack();
  await page.mouse.wheel(0, 3000);
  await page.waitForTimeout(300);
  assert.deepEqual(messages, []);
  assert.equal(requests.length, 1);
  assert.match(requests[0], /^file:/);
  await context.close();
});

test('the page shows the totals of its data', async () => {
  const { page, context, header } = await open({ rows: 40, replays: 3 });
  const shown = await page.evaluate(() => ({
    totals: window.report.totals,
    rows: window.report.rows,
    successes: window.report.successes,
    text: document.querySelector('#success').textContent,
  }));
  assert.deepEqual(shown.totals, header.totals);
  assert.equal(shown.rows, header.totals.runs);
  assert.equal(shown.successes, header.totals.successes);
  assert.match(shown.text, new RegExp(`${header.totals.successes} of 40 runs docked`));
  const low = Math.round(100 * header.totals.interval[0]),
    high = Math.round(100 * header.totals.interval[1]);
  assert.match(shown.text, new RegExp(`${low}–${high} %`));
  await context.close();
});

test('a failed run that is clicked and played ends at the last true pose', async () => {
  const { page, context, header, last, messages } = await open({ rows: 40, replays: 12 });
  const failed = header.causes.flatMap((cause) => cause.runs).find((run) => last.has(run));
  await page.click(`button[aria-label="Open run ${failed}"]`);
  await page.selectOption('select[aria-label="Speed"]', '50');
  await page.click('button.play');
  const end = header.replays.find((replay) => replay.run === failed).end_s;
  await page.waitForFunction((time) => window.report.frame().time >= time, end, { timeout: 60000 });
  const frame = await frameOf(page);
  assert.equal(frame.run, failed);
  assert.equal(frame.solid, true);
  const off = Math.hypot(...[0, 1, 2].map((i) => frame.poses.body[i] - last.get(failed)[i]));
  assert.ok(off < 0.001, `${off} m off`);
  const turn = Math.abs([3, 4, 5, 6].reduce((sum, i) => sum + frame.poses.body[i] * last.get(failed)[i], 0));
  assert.ok(turn > 1 - 1e-6, `turned by ${2 * Math.acos(Math.min(1, turn))} rad`);
  assert.deepEqual(messages, []);
  await context.close();
});

test('starts on the axis alone lie in a map with numbers to both sides', async () => {
  const { page, context, messages } = await open({ rows: 4, straight: true });
  const labels = await page.locator('#starts g[aria-label="y-axis tick label"] text').allTextContents();
  assert.ok(labels.length > 2, labels.join(' '));
  assert.ok(
    labels.every((label) => label.length <= 4),
    labels.join(' '),
  );
  assert.deepEqual(messages, []);
  await context.close();
});

test('a click on the map, on a row or on a cause leads to the run', async () => {
  const { page, context, header } = await open({ rows: 40, replays: 3 });
  const failed = header.causes.flatMap((cause) => cause.runs);
  const cross = await page.locator('#starts g[aria-label="dot"]').last().locator('path').first().boundingBox();
  await page.mouse.move(cross.x + cross.width / 2, cross.y + cross.height / 2);
  await page.mouse.click(cross.x + cross.width / 2, cross.y + cross.height / 2);
  await page.waitForSelector('#run', { state: 'visible' });
  const run = await page.evaluate(() => Number(location.hash.replace('#run=', '')));
  assert.ok(failed.includes(run), `run ${run} of the cross did not fail`);
  await page.click('button.back');
  await page.click('#causes tbody button.link >> nth=0');
  assert.equal(await page.inputValue('#filter'), `outcome=${header.causes[0].outcome}`);
  await page.click('#runs tbody tr >> nth=0');
  await page.waitForSelector('#run', { state: 'visible' });
  assert.match(await page.textContent('.run-title'), new RegExp(header.causes[0].outcome));
  await context.close();
});

test('the view to the target has its point in the middle and near, as the point moves', async () => {
  for (const [with_browser, distance_m] of [
    [browser, Math.hypot(...NEAR_OUT)],
    [flat_browser, null],
  ]) {
    const { page, context, messages } = await open({ rows: 40, replays: 3 }, { hash: '#run=2' }, with_browser);
    await page.waitForSelector('canvas.stage');
    const goTo = (/** @type {number} */ share) =>
      page.locator('input[type=range]').first().evaluate((input, at) => {
        input.value = String(Number(input.min) + at * (Number(input.max) - Number(input.min)));
        input.dispatchEvent(new Event('input', { bubbles: true }));
      }, share);
    await goTo(0.1);
    const before = (await frameOf(page)).framed_near;
    assert.ok(Math.hypot(before[0], before[1]) > 0.05, `in the middle before: ${before}`);
    await page.click('button:text-is("Follow robot")');
    await page.click('button:text-is("Near target")');
    assert.equal(await page.getAttribute('button:text-is("Follow robot")', 'aria-pressed'), 'false');
    for (const share of [0.3, 0.8, 1, 0.1]) {
      await goTo(share);
      const [u, v, off_m] = (await frameOf(page)).framed_near;
      assert.ok(Math.hypot(u, v) < 0.002, `${share}: at ${u}, ${v}`);
      if (distance_m !== null) assert.ok(Math.abs(off_m - distance_m) < 0.001, `${share}: ${off_m} m off`);
    }
    await page.click('button:text-is("Reset view")');
    assert.equal(await page.getAttribute('button:text-is("Near target")', 'aria-pressed'), 'false');
    const after = (await frameOf(page)).framed_near;
    assert.ok(Math.abs(after[0] - before[0]) < 0.02 && Math.abs(after[1] - before[1]) < 0.02, `${after}, ${before}`);
    assert.deepEqual(
      messages.filter((message) => !/WebGL/.test(message)),
      [],
    );
    await context.close();
  }
});

test('keys play, step and go to both ends', async () => {
  const { page, context, header } = await open({ rows: 40, replays: 3 }, { hash: '#run=2' });
  const end = header.replays[1].end_s;
  await page.keyboard.press('End');
  assert.equal((await frameOf(page)).time, end);
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await frameOf(page)).time - 0.2) < 1e-9);
  await page.keyboard.press('ArrowLeft');
  assert.ok(Math.abs((await frameOf(page)).time - 0.1) < 1e-9);
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.report.frame().time > 0.5);
  await page.keyboard.press(' ');
  const stopped = (await frameOf(page)).time;
  await page.waitForTimeout(200);
  assert.equal((await frameOf(page)).time, stopped);
  await page.keyboard.press('Escape');
  await page.waitForSelector('#overview', { state: 'visible' });
  await context.close();
});

test('keys play and step wherever the focus is, but in a field', async () => {
  const { page, context } = await open({ rows: 40, replays: 3 }, { hash: '#run=2' });
  const time = async () => (await frameOf(page)).time;
  await page.mouse.click(1000, 60); // on nothing: the focus is on no element of the run
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await time()) - 0.1) < 1e-9);
  for (const button of ['Follow robot', 'From above', 'Copy']) {
    await page.click(`button:text-is("${button}")`);
    await page.keyboard.press(' ');
    await page.waitForFunction(() => document.querySelector('button.play').textContent === 'Pause');
    await page.keyboard.press(' ');
  }
  await page.keyboard.press('Home');
  await page.focus('select[aria-label="Speed"]');
  await page.keyboard.press('ArrowDown');
  assert.equal(await time(), 0);
  await page.keyboard.press('Escape');
  await page.waitForSelector('#overview', { state: 'visible' });
  await page.focus('#filter');
  await page.keyboard.type('a b');
  assert.equal(await page.inputValue('#filter'), 'a b');
  await context.close();
});

test('groups of buttons are one stop of the Tab key each', async () => {
  const { page, context, header } = await open({ rows: 40, replays: 3 });
  const stops = await page.evaluate(
    () =>
      [...document.querySelectorAll('#overview button, #overview select, #overview input, #overview [tabindex]')].filter(
        (e) => e.tabIndex >= 0 && e.offsetParent,
      ).length,
  );
  assert.ok(stops < 30, `${stops} stops`);
  const names = header.table.columns.length;
  assert.ok(names > 10);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  assert.ok(await page.evaluate(() => document.activeElement.matches('#runs .window')));
  await page.focus('#runs thead th:nth-child(1) button');
  await page.keyboard.press('ArrowRight');
  assert.ok(await page.evaluate(() => document.activeElement.matches('#runs thead th:nth-child(2) button')));
  await context.close();
});

test('the first view holds robot and target over the whole run, wide and narrow', async () => {
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
    [1920, 500],
  ]) {
    const { page, context } = await open({ rows: 40, replays: 3 }, { hash: '#run=2', width, height });
    const ends = (await frameOf(page)).framed;
    assert.ok(
      ends.every((v) => Math.abs(v) < 0.95),
      `${width} x ${height}: ${ends}`,
    );
    assert.ok(
      ends.some((v) => Math.abs(v) > 0.8),
      `${width} x ${height}: ${ends}`,
    );
    await context.close();
  }
});

test('images without a sighting are on the time axis, and the page says how many there were', async () => {
  const { page, context, messages } = await open({ rows: 40, replays: 1, images: true }, { hash: '#run=1' });
  assert.equal(await page.locator('.sighting-strip span').count(), 20);
  await page.keyboard.press('End');
  assert.match(await page.textContent('.sighting-head'), /Images 20 of 20, .* s: no sighting reported/);
  assert.match(await page.textContent('.sightings'), /20 of 200 times are shown/);
  await page.click('button[aria-label="Image before"]');
  assert.match(await page.textContent('.sighting-head'), /Images 19 of 20/);
  await page.waitForFunction(() => {
    const pixel = document.querySelector('.cameras canvas')?.getContext('2d').getImageData(5, 5, 1, 1).data;
    return pixel?.[0] > 150;
  });
  // Chromium says so of this test's own reading, when it reads often.
  assert.deepEqual(messages.filter((message) => !message.includes('willReadFrequently')), []);
  await context.close();
});

test('curves of the design come before the table, with the line of the aim', async () => {
  const { page, context } = await open({ rows: 40, replays: 1 });
  const [curves, runs] = await Promise.all(['#curves', '#runs'].map((name) => page.locator(name).boundingBox()));
  assert.ok(curves.y < runs.y);
  assert.match(await page.textContent('#curves'), /Success over start\.r \[m\]/);
  assert.match(await page.textContent('#curves svg'), /aim: success >= 0\.9/);
  assert.equal(await page.locator('#curves g[aria-label="dot"] :is(path, circle)').count(), 8);
  assert.match(await page.textContent('#requirements'), /not met: success >= 0\.9/);
  await context.close();
});

test('the image of each camera is drawn under its marks', async () => {
  const { page, context } = await open({ rows: 40, replays: 3 }, { hash: '#run=1' });
  await page.keyboard.press('End');
  const grey = await page.waitForFunction(() => {
    const canvas = document.querySelector('.cameras canvas');
    const pixel = canvas?.getContext('2d').getImageData(5, 5, 1, 1).data;
    return pixel && pixel[0] > 150 ? [...pixel] : null; // the sky of the made-up image
  });
  assert.equal((await grey.jsonValue())[0], (await grey.jsonValue())[2]);
  assert.equal(await page.locator('.cameras canvas').count(), 2);
  await context.close();
});

test('the ground sinks under the wheels, and rises again when time goes back', async () => {
  const { page, context } = await open({ rows: 40, replays: 3 }, { hash: '#run=1' });
  const shot = () => page.evaluate(() => document.querySelector('canvas.stage').toDataURL());
  await page.click('button:text-is("From above")');
  const before_drive = await shot();
  await page.keyboard.press('End');
  const after_drive = await shot();
  await page.keyboard.press('Home');
  assert.notEqual(after_drive, before_drive);
  assert.equal(await shot(), before_drive);
  await context.close();
});

test('a hundred thousand runs are sorted and filtered', async () => {
  const { page, context, header, messages } = await open({ rows: 100000, replays: 1 });
  const result = await page.evaluate(() => {
    const { report } = window;
    const depth = report.column('tip_depth_m');
    const begin = performance.now();
    report.sort('tip_depth_m', true);
    const sort_ms = performance.now() - begin;
    const sorted = [...report.shown()].map((row) => depth[row]);
    report.filter('outcome=face_catch soil=loose tip_depth_m<0.1');
    const found = [...report.shown()];
    return {
      sort_ms,
      sorted: sorted.every((v, i) => i === 0 || Number.isNaN(v) || sorted[i - 1] >= v),
      count: sorted.length,
      found: found.length,
      right: found.every(
        (row) =>
          depth[row] < 0.1 &&
          report.text('outcome', row) === 'face_catch' &&
          report.text('soil', row) === 'loose',
      ),
      elements: document.querySelectorAll('#runs tbody tr').length,
    };
  });
  assert.equal(result.count, 100000);
  assert.ok(result.sorted && result.right);
  assert.ok(result.found > 0 && result.found < header.totals.runs);
  assert.equal(result.elements, 24);
  assert.match(await page.textContent('.counts'), /chosen runs docked/);
  await page.fill('#filter', 'no_such_column=1');
  assert.match(await page.textContent('.counts'), /There is no column "no_such_column"/);
  await page.fill('#filter', '');
  await page.focus('.window');
  await page.keyboard.press('End');
  assert.match(await page.textContent('tr[aria-selected="true"]'), /^\d+/);
  assert.equal(await page.getAttribute('tr[aria-selected="true"]', 'aria-rowindex'), '100001');
  assert.deepEqual(messages, []);
  await context.close();
});

test('without WebGL the run is shown from above, and the rest works', async () => {
  const { page, context, last, messages } = await open(
    { rows: 40, replays: 3 },
    { hash: '#run=3' },
    flat_browser,
  );
  await page.keyboard.press('End');
  const frame = await frameOf(page);
  assert.equal(frame.solid, false);
  assert.ok(Math.hypot(frame.poses.body[0] - last.get(3)[0], frame.poses.body[1] - last.get(3)[1]) < 0.001);
  assert.match(await page.textContent('#run'), /no WebGL/);
  await page.click('button.back');
  await page.waitForSelector('#starts svg', { state: 'visible' });
  assert.deepEqual(messages, []);
  await context.close();
});

test('a damaged file says so', async () => {
  const { header, blobs } = makeReport({ rows: 40, replays: 1 });
  const payload = packPayload(header, blobs);
  const zipped = (bytes) => gzipSync(bytes).toString('base64');
  const wrong_magic = Buffer.from(payload);
  wrong_magic.write('X', 0);
  const cases = {
    empty: '',
    no_base64: '%%%',
    cut: zipped(payload).slice(0, 4000),
    magic: zipped(wrong_magic),
    header: zipped(payload.subarray(0, 300)),
    blobs: zipped(payload.subarray(0, 12 + payload.readUInt32LE(8) + 8)),
  };
  for (const [name, text] of Object.entries(cases)) {
    const { page, context, messages } = await openText(`damaged-${name}`, text);
    const shown = await page.textContent('body');
    assert.match(shown, /damaged or incomplete/, name);
    assert.equal(await page.locator('[role=alert]').count(), 1);
    assert.deepEqual(messages, [], name);
    await context.close();
  }
});

test('the chance of a strength is named as it is adjusted', async () => {
  const { page, context } = await open({ rows: 40 });
  const shown = await page.textContent('#sensitivity');
  assert.match(shown, /0\.42 +p \(Holm\) 0\.0004/);
  assert.doesNotMatch(shown, / p 0/);
  await context.close();
});

test('a campaign of too few runs for its draws says so in the place of strengths', async () => {
  const report = makeReport({ rows: 10 });
  const [arm] = report.header.sensitivity;
  report.header.sensitivity = [{ ...arm, draws: [], warning: 'warning: no list: 10 runs for 4 draws' }];
  const file = join(folder, 'too_few.html');
  writeFileSync(file, pageWith(packPayload(report.header, report.blobs)));
  const { page, context, messages } = await openReport(browser, file);
  assert.match(await page.textContent('#sensitivity'), /warning: no list: 10 runs for 4 draws\./);
  assert.equal(await page.locator('#sensitivity svg').count(), 0);
  assert.deepEqual(messages, []);
  await context.close();
});

test('a replay without bodies, ground and lines can be used', async () => {
  const report = makeReport({ rows: 1, replays: 1, single: true });
  report.header.scenes[0] = { bodies: [] };
  report.header.meshes = [];
  const [replay] = report.header.replays;
  for (const name of ['bodies', 'ground', 'lines', 'near']) delete replay[name];
  const file = join(folder, 'no_bodies.html');
  writeFileSync(file, pageWith(packPayload(report.header, report.blobs)));
  const { page, context, messages } = await openReport(browser, file);
  for (const name of ['Follow robot', 'Reset view', 'From above', 'Reset view', 'Follow robot', 'From above']) {
    await page.click(`button:has-text("${name}")`);
  }
  await page.click('canvas.stage');
  await page.keyboard.press('End');
  assert.ok((await frameOf(page)).time > 60);
  assert.deepEqual(messages, []);
  await context.close();
});

test('a single run opens at once', async () => {
  const { page, context } = await open({ rows: 1, replays: 1, single: true });
  assert.equal((await frameOf(page)).run, 1);
  assert.equal(await page.isVisible('#overview'), false);
  await context.close();
});

test('a report without any optional part is shown', async () => {
  const report = makeReport({ rows: 10, bare: true });
  for (const name of [
    'sensitivity',
    'arms',
    'acceptance',
    'groups',
    'causes',
    'scenes',
    'meshes',
    'replays',
    'left_out',
    'worst',
    'system',
    'replay_command',
  ]) {
    delete report.header[name];
  }
  report.header.table.columns = report.header.table.columns.filter((column) =>
    ['run', 'outcome', 'success'].includes(column.name),
  );
  const file = join(folder, 'bare.html');
  writeFileSync(file, pageWith(packPayload(report.header, report.blobs)));
  const { page, context, messages } = await openReport(browser, file, { hash: '#run=4' });
  assert.match(await page.textContent('#run'), /no replay of this run/);
  assert.deepEqual(messages, []);
  await context.close();
});

test('text of the data is shown as text', async () => {
  const report = makeReport({ rows: 10, replays: 1 });
  report.header.title = '<img src=x onerror=alert(1)></script><b>bold</b>';
  report.header.replays[0].messages = '</script><script>window.broken = true</script>';
  const file = join(folder, 'hostile.html');
  writeFileSync(file, pageWith(packPayload(report.header, report.blobs)));
  const { page, context, messages } = await openReport(browser, file);
  assert.equal(await page.textContent('h1'), report.header.title);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.deepEqual(messages, []);
  await context.close();
});
