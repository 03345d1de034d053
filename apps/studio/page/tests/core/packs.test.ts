import { describe, expect, test } from 'vitest';
import { decodePack, encodePack } from '../../src/core/packs';

/** Written by hand from docs/studio/protocol.md: magic, length 104, header, 2 x 3 floats, 3 bytes and a zero. */
function golden(): Uint8Array {
  const header =
    '{"pack":"flat","arrays":[{"name":"p","type":"f32","shape":[2,3]},{"name":"b","type":"u8","shape":[3,1]}]}';
  const length = Math.ceil(header.length / 4) * 4;
  const bytes = new Uint8Array(8 + length + 24 + 4);
  bytes.set([0x4c, 0x53, 0x4d, 0x31, length, 0, 0, 0]);
  bytes.set(new TextEncoder().encode(header.padEnd(length, ' ')), 8);
  // 1.0f, -2.0f, 0.5f, 0, 0, 1.0f, little-endian
  bytes.set([0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0, 0, 0, 0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f], 8 + length);
  bytes.set([7, 8, 9, 0], 8 + length + 24);
  return bytes;
}

describe('packs', () => {
  test('are read as the protocol says, byte for byte', () => {
    const bytes = golden();
    const pack = decodePack(bytes.buffer as ArrayBuffer) as unknown as { pack: string; p: Float32Array; b: Uint8Array };
    expect(pack.pack).toBe('flat');
    expect([...pack.p]).toEqual([1, -2, 0.5, 0, 0, 1]);
    expect([...pack.b]).toEqual([7, 8, 9]);
  });

  test('arrays are views of the message, not copies', () => {
    const bytes = golden();
    const pack = decodePack(bytes.buffer as ArrayBuffer) as unknown as { p: Float32Array };
    expect(pack.p.buffer).toBe(bytes.buffer);
  });

  test('are written as they are read', () => {
    const message = encodePack({ pack: 'flat' }, [
      { name: 'p', data: Float32Array.of(1, -2, 0.5, 0, 0, 1), columns: 3 },
      { name: 'b', data: Uint8Array.of(7, 8, 9) },
    ]);
    expect([...new Uint8Array(message)]).toEqual([...golden()]);
    const numbers = encodePack({ pack: 'x' }, [{ name: 'n', data: Uint32Array.of(4294967295) }]);
    expect([...(decodePack(numbers) as unknown as { n: Uint32Array }).n]).toEqual([4294967295]);
  });

  test.each([
    ['too short', () => new Uint8Array(4)],
    ['of another kind', () => golden().fill(0x58, 0, 4)],
    ['with a header beyond the end', () => golden().fill(0xf0, 4, 6)],
    ['with an array beyond the end', () => golden().slice(0, -8)],
  ])('a message %s is refused', (_what, make) => {
    expect(() => decodePack(make().buffer as ArrayBuffer)).toThrow();
  });
});
