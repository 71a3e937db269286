// Opens a report in Chromium as a user does: from disk, without network.
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const { chromium } = createRequire(new URL('../../sim/page/web/package.json', import.meta.url))(
  'playwright-core',
);

/** Starts Chromium; drawing is done in software. @param {string[]} [more] flags */
export function startBrowser(more = []) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...more],
  });
}

/**
 * Opens a file offline and waits until the page is ready or has refused its data.
 * @param {any} browser @param {string} file @param {{width?: number, height?: number, hash?: string, colorScheme?: any}} [options]
 */
export async function openReport(
  browser,
  file,
  { width = 1280, height = 800, hash = '', colorScheme = 'light' } = {},
) {
  const context = await browser.newContext({ viewport: { width, height }, offline: true, colorScheme });
  const page = await context.newPage();
  page.setDefaultTimeout(15000);
  const messages = [],
    requests = [];
  page.on('console', (message) => messages.push(message.text()));
  page.on('pageerror', (error) => messages.push(String(error)));
  page.on('request', (request) => requests.push(request.url()));
  const begin = Date.now();
  await page.goto(pathToFileURL(file).href + hash, { waitUntil: 'commit', timeout: 120000 });
  await page.waitForFunction(() => window.report?.ready || window.report?.problem, null, {
    timeout: 120000,
    polling: 20,
  });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return { page, context, messages, requests, ready_ms: Date.now() - begin };
}
