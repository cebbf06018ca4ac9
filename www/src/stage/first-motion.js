// The motion before the wasm has loaded: a short rollout, made at build time, in a small binary format.
// Plain JavaScript, because the build script runs it in Node too.
//
// Layout: 4 bytes little-endian length of the header, the header (JSON, UTF-8, padded with blanks to an even
// length), then 16-bit integers [frames x nodes x 3] in units of `unit` metres. Each is the difference
// between
// the coordinate and its linear extrapolation (frame 0: the coordinate; frame 1: the step from frame 0). A
// smooth motion gives small numbers, which servers compress well.

/**
 * @typedef {object} FirstMotion
 * @property {number} frames
 * @property {number} frameTime seconds between frames
 * @property {import("vcgpdm").Figure} figure
 * @property {string[]} joints names, in the skeleton's order
 * @property {{ name: string, joints: number[] }[]} parts
 * @property {readonly string[]} [shown] the motions after the first one, all as long as it
 * @property {Float32Array} positions world positions of the figure's nodes [frames x nodes x 3], y up, metres
 */

const FORMAT = "vcgpdm-first-motion/1";
/** Metres: a millimetre, which is less than a pixel of a figure 1000 pixels high. */
const UNIT = 0.001;
const LIMIT = 32767;

/** The linear extrapolation of each coordinate. */
class Expected {
  /** @param {number} width coordinates in a frame */
  constructor(width) {
    this.width = width;
    this.last = new Int32Array(width);
    this.step = new Int32Array(width);
  }

  /** @param {number} i */
  next(i) {
    return (this.last[i % this.width] ?? 0) + (this.step[i % this.width] ?? 0);
  }

  /**
   * @param {number} i
   * @param {number} now
   */
  found(i, now) {
    const at = i % this.width;
    this.step[at] = i < this.width ? 0 : now - (this.last[at] ?? 0);
    this.last[at] = now;
  }
}

/**
 * @param {FirstMotion} motion
 * @returns {Uint8Array}
 */
export function encodeFirstMotion(motion) {
  const nodes = motion.figure.nodes.length;
  const width = nodes * 3;
  if (motion.positions.length !== motion.frames * width) {
    throw new Error(`expected ${motion.frames * width} coordinates, found ${motion.positions.length}`);
  }
  const { positions: _, ...described } = motion;
  let header = JSON.stringify({ format: FORMAT, unit: UNIT, ...described });
  const encoder = new TextEncoder();
  if (encoder.encode(header).length % 2 === 1) header += " ";
  const head = encoder.encode(header);
  const bytes = new Uint8Array(4 + head.length + 2 * motion.positions.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, head.length, true);
  bytes.set(head, 4);
  const expected = new Expected(width);
  for (let i = 0; i < motion.positions.length; i++) {
    const now = Math.round((motion.positions[i] ?? 0) / UNIT);
    const off = now - expected.next(i);
    if (!(Math.abs(off) <= LIMIT)) throw new Error(`coordinate ${i} jumps by ${off * UNIT} metres`);
    view.setInt16(4 + head.length + 2 * i, off, true);
    expected.found(i, now);
  }
  return bytes;
}

/**
 * @param {ArrayBuffer} buffer
 * @returns {FirstMotion}
 */
export function decodeFirstMotion(buffer) {
  const view = new DataView(buffer);
  const length = buffer.byteLength >= 4 ? view.getUint32(0, true) : 0;
  if (length === 0 || 4 + length > buffer.byteLength) throw new Error("the first motion is cut short");
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  if (header.format !== FORMAT) throw new Error(`expected the format ${FORMAT}, found ${header.format}`);
  const width = header.figure.nodes.length * 3;
  const count = header.frames * width;
  if (buffer.byteLength !== 4 + length + 2 * count) {
    throw new Error(`expected ${2 * count} bytes of positions, found ${buffer.byteLength - 4 - length}`);
  }
  const positions = new Float32Array(count);
  const expected = new Expected(width);
  for (let i = 0; i < count; i++) {
    const now = expected.next(i) + view.getInt16(4 + length + 2 * i, true);
    positions[i] = now * header.unit;
    expected.found(i, now);
  }
  const { format: _, unit: __, ...described } = header;
  return { ...described, positions };
}
