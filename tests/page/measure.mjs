// Measures the page: time until ready, sorting, a frame of the replay. Usage: node measure.mjs [ROWS REPLAYS]...
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openReport, startBrowser } from './browser.mjs';
import { makeReport } from './made_up_report.mjs';
import { packPayload, pageWith } from './payload_writer.mjs';

const sizes = process.argv.length > 2 ? process.argv.slice(2).map(Number) : [40, 40, 1e5, 40, 1e6, 40];
const folder = mkdtempSync(join(tmpdir(), 'report-'));
const browser = await startBrowser();
for (let i = 0; i < sizes.length; i += 2) {
  const file = join(folder, `${sizes[i]}.html`);
  const { header, blobs } = makeReport({ rows: sizes[i], replays: sizes[i + 1] });
  writeFileSync(file, pageWith(packPayload(header, blobs)));
  const { page, context } = await openReport(browser, file);
  const figures = await page.evaluate(measureIn);
  console.log(
    `${sizes[i]} runs, ${sizes[i + 1]} replays: file ${(statSync(file).size / 1e6).toFixed(1)} MB, ready ${(figures.ready / 1000).toFixed(2)} s, ` +
      `sort ${(figures.sort / 1000).toFixed(2)} s, filter ${(figures.filter / 1000).toFixed(2)} s, frame ${figures.frame.map((v) => v.toFixed(1)).join(' / ')} ms (median / 90 %)`,
  );
  await context.close();
}
await browser.close();
rmSync(folder, { recursive: true });

/** Runs in the page. */
async function measureIn() {
  const { report } = window;
  const timed = (work) => {
    const begin = performance.now();
    work();
    return performance.now() - begin;
  };
  const sort = timed(() => report.sort('tip_depth_m', true));
  const filter = timed(() => report.filter('outcome=timeout soil=loose sim_time_s<180'));
  const frames = [];
  if (report.header.replays?.length > 0) {
    report.openRun(report.header.replays[0].run);
    await new Promise((done) => setTimeout(done, 1000));
    const slider = document.querySelector('.strips input');
    for (let k = 0; k < 150; ++k) {
      slider.value = String((Number(slider.max) * k) / 150);
      slider.dispatchEvent(new Event('input'));
      frames.push(report.frame().frame_ms);
      await new Promise((done) => requestAnimationFrame(done));
    }
    frames.sort((a, b) => a - b);
  }
  return { ready: report.ready_ms, sort, filter, frame: frames.length > 0 ? [frames[75], frames[135]] : [] };
}
