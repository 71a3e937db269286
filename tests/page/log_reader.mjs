// Logs by MCAP's own reader, messages by readers of others.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../sim/page/web/package.json', import.meta.url));
const { McapIndexedReader, McapStreamReader } = require('@mcap/core');
export const { parse } = require('@foxglove/rosmsg');
export const { MessageReader } = require('@foxglove/rosmsg2-serialization');
const { ros2jazzy } = require('@foxglove/rosmsg-msgs-common');
const { decompress } = require('fzstd');

const decompressHandlers = {
  zstd: (bytes, size) => decompress(new Uint8Array(bytes), new Uint8Array(Number(size))),
};

/** @param {Buffer} bytes of a log that has its end */
export function logReader(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) =>
      new Uint8Array(bytes.buffer, bytes.byteOffset + Number(offset), Number(length)),
  };
  return McapIndexedReader.Initialize({ readable, decompressHandlers });
}

/** A reader of streams that checks all check values. */
export function openStream() {
  return new McapStreamReader({ validateCrcs: true, decompressHandlers });
}

/** All messages by the file's indexes: [{topic, type, schema, data, time}]. @param {Buffer} bytes */
export async function messagesOf(bytes) {
  const reader = await logReader(bytes);
  const found = [];
  for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    if (channel.messageEncoding !== 'cdr' || schema.encoding !== 'ros2msg') throw new Error(channel.topic);
    found.push({
      topic: channel.topic,
      type: schema.name,
      schema: new TextDecoder().decode(schema.data),
      data: message.data,
      time: Number(message.logTime) * 1e-9,
    });
  }
  if (BigInt(found.length) !== reader.statistics.messageCount) throw new Error('messages are missing');
  return found;
}

/** By the schema that the log holds. @param {{schema: string, data: Uint8Array}} message */
export function decodeMessage({ schema, data }) {
  return new MessageReader(parse(schema, { ros2: true })).readMessage(data);
}

/** The definition that ROS has of a message, with all that are in it; none for those of our own. */
export function definitionOfRos(type) {
  const of = (name) => ros2jazzy[name] ?? ros2jazzy[name.replace('/msg/', '/')];
  if (!of(type)) return undefined;
  const all = [{ definitions: of(type).definitions }];
  const names = new Set();
  for (let i = 0; i < all.length; ++i) {
    for (const field of all[i].definitions) {
      if (!field.isComplex || names.has(field.type)) continue;
      names.add(field.type);
      all.push({ name: field.type, definitions: of(field.type).definitions });
    }
  }
  return all;
}
