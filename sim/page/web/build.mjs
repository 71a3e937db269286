// Builds page.html and LICENSES.txt from the sources. The same sources give the same bytes.
// Usage: node build.mjs [--check]   --check: writes nothing, exit code 1 if a built file differs
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { licences } from './licences.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const shared = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  write: false,
  legalComments: 'none',
  charset: 'utf8',
  logLevel: 'warning',
  target: ['chrome115', 'firefox115', 'safari16.4'],
};

/** The text of one bundle, and the files that went into it. */
async function bundle(entry, options) {
  const result = await build({ ...shared, ...options, entryPoints: [entry], metafile: true });
  return { text: result.outputFiles[0].text.trim(), inputs: Object.keys(result.metafile.inputs) };
}

/** Puts each text in the place of its name. A function as the second argument keeps "$&" of the text as it is. */
function fill(template, texts) {
  return Object.entries(texts).reduce(
    (page, [name, text]) => page.replace(`@${name}@`, () => text),
    template,
  );
}

const script = await bundle('src/main.js', { format: 'iife' });
const style = await bundle('src/all.css', {});
const code = script.text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const hash = `sha256-${createHash('sha256').update(code).digest('base64')}`;
const page = fill(readFileSync(join(here, 'src/page.html'), 'utf8'), {
  SCRIPT_HASH: hash,
  STYLE: style.text,
  SCRIPT: code,
});
if (page.split('@PAYLOAD@').length !== 2) throw new Error('the place of the payload must occur once');

let differs = false;
const built = { 'page.html': page, 'LICENSES.txt': licences(here, [...script.inputs, ...style.inputs]) };
for (const [name, text] of Object.entries(built)) {
  const path = join(here, name);
  if (!process.argv.includes('--check')) {
    writeFileSync(path, text);
    console.log(`${name}: ${Buffer.byteLength(text)} bytes`);
  } else if (!existsSync(path) || readFileSync(path, 'utf8') !== text) {
    console.error(`${name} is not what its sources give: run scripts/report_page`);
    differs = true;
  }
}
process.exit(differs ? 1 : 0);
