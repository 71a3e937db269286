// A report that the program made of real runs, in a browser. Needs build/dockyard.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openReport, startBrowser } from './browser.mjs';
import { decodeMessage, messagesOf } from './log_reader.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
let folder, browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'dockyard-report-'));
  const words = ['campaign', 'scenarios/ci_4.yaml', '--set', 'scenario.time_limit_s=30', '--quiet', '--report'];
  execFileSync('build/dockyard', [...words, '--out', folder], { cwd: root, stdio: 'ignore' });
  browser = await startBrowser();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

const open = (hash = '') => openReport(browser, join(folder, 'report.html'), { hash });

test('the page has the totals of results.csv and says nothing on the console', async () => {
  const { page, context, messages, requests } = await open();
  const [head, ...rows] = readFileSync(join(folder, 'results.csv'), 'utf8').trim().split('\n');
  const success = head.split(',').indexOf('success');
  const totals = await page.evaluate(() => window.report.totals);
  assert.equal(totals.runs, rows.length);
  assert.equal(totals.successes, rows.filter((row) => row.split(',')[success] === '1').length);
  assert.deepEqual(messages, []);
  assert.equal(requests.length, 1);
  await context.close();
});

test('a replay ends where the log says that the robot was', async () => {
  const { page, context, messages } = await open('#run=1');
  await page.keyboard.press('End');
  const frame = await page.evaluate(() => window.report.frame());
  const log = await messagesOf(readFileSync(join(folder, 'runs/001/run.mcap')));
  const last = log.filter(({ topic }) => topic === '/tf').at(-1);
  for (const { child_frame_id, transform } of decodeMessage(last).transforms) {
    if (!(child_frame_id in frame.poses)) continue;
    const { x, y, z } = transform.translation;
    const pose = frame.poses[child_frame_id];
    const off = Math.hypot(pose[0] - x, pose[1] - y, pose[2] - z);
    assert.ok(off < 0.001, `${child_frame_id}: ${off} m off`);
  }
  assert.deepEqual(Object.keys(frame.poses).sort(), ['arm', 'left_wheel', 'right_wheel', 'robot', 'station']);
  assert.deepEqual(messages, []);
  await context.close();
});

test("a program's run shows its marks and values, and its command can be pasted", async () => {
  const out = join(folder, 'program');
  const program = ['run', 'examples/python/dock_straight.yaml', '--allow-commands', '--set', 'time_limit_s=3'];
  try {
    execFileSync('build/dockyard', [...program, '--out', out], { cwd: root, stdio: 'ignore' });
  } catch (failure) {
    assert.equal(failure.status, 4); // no success, as it has no time
  }
  execFileSync('build/dockyard', ['report', out], { cwd: root, stdio: 'ignore' });
  const { page, context, messages } = await openReport(browser, join(out, 'report.html'));
  await page.keyboard.press('End');
  const sightings = await page.textContent('.sightings');
  assert.match(sightings, /Sighting 1 of 1, 0\.\d s: ✕ not accepted: no pose/);
  assert.match(sightings, /left: 1 mark measured/);
  assert.match(await page.textContent('.scalars'), /Values m *reeled \(belief\)/);
  const command = await page.textContent('.command code');
  assert.match(command, /dockyard replay \S+ --allow-commands$/);
  const env = { ...process.env, PATH: `build:${process.env.PATH}` }; // of a program that is called without its folder
  execFileSync('sh', ['-c', command], { cwd: root, stdio: 'ignore', env });
  assert.deepEqual(messages, []);
  await context.close();
});

test('the images that a camera took are drawn', async () => {
  const { page, context } = await open('#run=1');
  await page.keyboard.press('End');
  const shades = await page.waitForFunction(() => {
    const canvas = document.querySelector('.cameras canvas');
    if (!canvas?.width) return null;
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const found = new Set();
    for (let i = 0; i < data.length; i += 4) found.add(data[i]);
    return found.size > 50 ? found.size : null;
  });
  assert.ok((await shades.jsonValue()) > 50);
  await context.close();
});
