// Writes a made-up report: node make_page.mjs FILE.html ROWS REPLAYS
import { writeFileSync } from 'node:fs';
import { makeReport } from './made_up_report.mjs';
import { packPayload, pageWith } from './payload_writer.mjs';

const [file, rows = '40', replays = '40'] = process.argv.slice(2);
const { header, blobs } = makeReport({ rows: Number(rows), replays: Number(replays) });
writeFileSync(file, pageWith(packPayload(header, blobs)));
