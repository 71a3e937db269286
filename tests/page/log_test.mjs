// A run's log as other tools read it: MCAP's own reader, and the message definitions of ROS 2 itself.
// Needs build/dockyard.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { decodeMessage, definitionOfRos, logReader, MessageReader, messagesOf, openStream, parse } from './log_reader.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
let folder, bytes;

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'dockyard-log-'));
  const words = ['run', 'scenarios/axel_typical.yaml', '--set', 'time_limit_s=32', '--out', folder];
  try {
    execFileSync('build/dockyard', words, { cwd: root, stdio: 'ignore' });
  } catch (error) {
    assert.equal(error.status, 4); // it did not dock in so short a time
  }
  bytes = readFileSync(join(folder, 'run.mcap'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

test('every message decodes by its own schema, and the same by the definitions of ROS', async () => {
  const readers = new Map();
  const topics = new Set();
  let officials = 0;
  for (const { topic, type, schema, data } of await messagesOf(bytes)) {
    topics.add(topic);
    if (!readers.has(type)) {
      const official = definitionOfRos(type);
      readers.set(type, {
        own: new MessageReader(parse(schema, { ros2: true })),
        ros: official && new MessageReader(official),
      });
    }
    const { own, ros } = readers.get(type);
    const message = own.readMessage(data);
    if (!ros) {
      assert.ok(type.startsWith('dockyard_msgs/'), type);
      continue;
    }
    ++officials;
    assert.deepEqual(ros.readMessage(data), message);
  }
  assert.ok(officials > 1000);
  for (const topic of ['/tf', '/imu', '/motors', '/commands', '/tether', '/ground', '/truth/scalars', '/plan',
    '/belief/pose', '/rosout', '/dockyard/frame', '/sighting', '/camera/left/camera_info',
    '/camera/right/image/compressed']) {
    assert.ok(topics.has(topic), topic);
  }
});

test('images are whole PNG files of the size that the camera has', async () => {
  const all = await messagesOf(bytes);
  const info = decodeMessage(all.find(({ topic }) => topic === '/camera/left/camera_info'));
  const images = all.filter(({ topic }) => topic === '/camera/left/image/compressed');
  assert.ok(images.length >= 2);
  for (const each of images) {
    const image = decodeMessage(each);
    assert.equal(image.format, 'png');
    const png = Buffer.from(image.data);
    assert.equal(png.subarray(1, 4).toString(), 'PNG');
    assert.equal(png.readUInt32BE(16), info.width);
    assert.equal(png.readUInt32BE(20), info.height);
    assert.equal(png.subarray(-8, -4).toString(), 'IEND');
  }
});

test('each image has a camera_info of its time, and a frame on the robot', async () => {
  const all = await messagesOf(bytes);
  const stamps = (topic) => all.filter((each) => each.topic === topic).map((each) => decodeMessage(each).header);
  const frames = new Map();
  for (const each of all.filter(({ topic }) => topic === '/tf')) {
    for (const { header, child_frame_id } of decodeMessage(each).transforms) {
      frames.set(child_frame_id, header.frame_id);
    }
  }
  for (const side of ['left', 'right']) {
    assert.deepEqual(stamps(`/camera/${side}/camera_info`), stamps(`/camera/${side}/image/compressed`));
    assert.equal(frames.get(side), 'robot');
  }
  assert.equal(frames.get('robot'), 'world');
  const info = decodeMessage(all.find(({ topic }) => topic === '/camera/right/camera_info'));
  const fx = 1024 / (Math.PI / 2); // models/axel/axel.yaml: 90 deg across 1024 px, 0.35 m apart
  assert.ok(Math.abs(info.p[3] + 0.35 * fx) < 1e-6, info.p);
});

test('a log that was cut short gives its first messages to a reader of streams', () => {
  const count = (part) => {
    const reader = openStream();
    reader.append(part);
    let messages = 0;
    for (let record; (record = reader.nextRecord()); ) messages += record.type === 'Message';
    return messages;
  };
  const all = count(bytes);
  const half = count(bytes.subarray(0, bytes.length / 2));
  assert.ok(half > 100 && half < all, `${half} of ${all}`);
});

test('chunks are shorter than a second', async () => {
  const reader = await logReader(bytes);
  assert.ok(reader.chunkIndexes.length >= 30);
  for (const chunk of reader.chunkIndexes) assert.ok(chunk.messageEndTime - chunk.messageStartTime < 1000000000n);
});
