// Writes a JPEG by headless Chromium, of images side by side (all 384 px high, one alone as large as it is) or
// of a report.
// Usage: node jpeg_of.mjs FILE.jpg IMAGE.png...
//        node jpeg_of.mjs FILE.jpg REPORT.html#run=N@SHARE   the run N at that share of its time
import { readFileSync } from 'node:fs';
import { openReport, startBrowser } from '../tests/page/browser.mjs';

const kHeight_px = 384;
const kReport_px = { width: 1280, height: 820 };
const kRowQuality = 88; // grey images, whose marks are small
const kQuality = 80;

/** The images in a row. @param {any} browser @param {string[]} files */
async function row(browser, files) {
  const page = await browser.newPage({ viewport: { width: 2000, height: 1200 } });
  const height = files.length > 1 ? `height: ${kHeight_px}px` : '';
  const images = files.map((file) => `<img src="data:image/png;base64,${readFileSync(file).toString('base64')}">`);
  await page.setContent(
    `<style>body { margin: 0 } div { display: inline-flex } img { ${height} }</style><div>${images.join('')}</div>`,
  );
  return page.locator('div');
}

/** A report's run, its slider at a share of the run. @param {any} browser @param {string} place */
async function reportAt(browser, place) {
  const [file, hash, share] = /^(.*)(#.*)@(.*)$/.exec(place).slice(1);
  const { page } = await openReport(browser, file, { ...kReport_px, hash });
  const slider = page.locator('input[type=range]').first();
  await slider.waitFor();
  await slider.evaluate((input, at) => {
    input.value = String(Number(input.min) + at * (Number(input.max) - Number(input.min)));
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }, Number(share));
  await page.waitForTimeout(1500); // images and the scene are drawn
  return page;
}

const [target, ...sources] = process.argv.slice(2);
const browser = await startBrowser();
const shown = sources[0].includes('.html#') ? await reportAt(browser, sources[0]) : await row(browser, sources);
const quality = sources.length > 1 ? kRowQuality : kQuality;
await shown.screenshot({ path: target, type: 'jpeg', quality });
await browser.close();
