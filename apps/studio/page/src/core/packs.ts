// Decoding of packs: a header in JSON and arrays that look into the message itself, so that a frame of 180 kB costs no
// copy. Layout: docs/studio/protocol.md, "Packs".

import type { Pack } from './protocol';

const kMagic = 0x314d534c; // "LSM1", little-endian
const text = new TextDecoder();

interface ArrayInfo {
  name: string;
  type: 'f32' | 'u32' | 'u8';
  shape: number[];
}

/** The pack in a message. Throws with a sentence when the bytes are no pack. */
export function decodePack(message: ArrayBuffer): Pack {
  if (message.byteLength < 8) throw new Error('a pack has at least 8 bytes');
  const words = new DataView(message);
  if (words.getUint32(0, true) !== kMagic) throw new Error('a pack starts with LSM1');
  const length = words.getUint32(4, true);
  if (length % 4 !== 0 || 8 + length > message.byteLength) throw new Error(`a header of ${length} bytes does not fit`);
  const { arrays, ...header } = JSON.parse(text.decode(new Uint8Array(message, 8, length))) as { arrays: ArrayInfo[] };
  const pack: Record<string, unknown> = header;
  let at = 8 + length;
  for (const info of arrays) {
    const count = info.shape.reduce((product, n) => product * n, 1);
    const bytes = info.type === 'u8' ? count : 4 * count;
    if (at + bytes > message.byteLength) throw new Error(`array ${info.name} ends behind the message`);
    pack[info.name] = view(message, info.type, at, count);
    at += (bytes + 3) & ~3;
  }
  return pack as unknown as Pack;
}

function view(message: ArrayBuffer, type: ArrayInfo['type'], at: number, count: number) {
  if (type === 'f32') return new Float32Array(message, at, count);
  if (type === 'u32') return new Uint32Array(message, at, count);
  return new Uint8Array(message, at, count);
}

/** The bytes of a pack; what the engine does, for tests and for the stand-in engine of dev/. */
export function encodePack(
  header: Record<string, unknown>,
  arrays: { name: string; data: Float32Array | Uint32Array | Uint8Array; columns?: number }[],
): ArrayBuffer {
  const infos = arrays.map(({ name, data, columns = 1 }) => ({
    name,
    type: data instanceof Float32Array ? 'f32' : data instanceof Uint32Array ? 'u32' : 'u8',
    shape: [data.length / columns, columns],
  }));
  const json = new TextEncoder().encode(JSON.stringify({ ...header, arrays: infos }));
  const length = (json.length + 3) & ~3;
  const total = arrays.reduce((sum, { data }) => sum + ((data.byteLength + 3) & ~3), 8 + length);
  const bytes = new Uint8Array(total);
  const words = new DataView(bytes.buffer);
  words.setUint32(0, kMagic, true);
  words.setUint32(4, length, true);
  bytes.fill(0x20, 8, 8 + length);
  bytes.set(json, 8);
  let at = 8 + length;
  for (const { data } of arrays) {
    bytes.set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), at);
    at += (data.byteLength + 3) & ~3;
  }
  return bytes.buffer;
}
