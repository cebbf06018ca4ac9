// The motion that walks before the wasm has loaded: a short rollout, made at build time, in a small binary form.
// Plain JavaScript, since the build script runs it in Node as well.
//
// Layout: 4 bytes little-endian length of the header, the header (JSON, UTF-8, padded with blanks to an even length),
// then 16-bit integers [frames x nodes x 3], each the difference to the frame before (to 0 in the first), in units of `unit` metres.

/**
 * @typedef {object} FirstMotion
 * @property {number} frames
 * @property {number} frameTime seconds between frames
 * @property {import("vcgpdm").Figure} figure
 * @property {string[]} joints names, in the skeleton's order
 * @property {{ name: string, joints: number[] }[]} parts
 * @property {Float32Array} positions world positions of the figure's nodes [frames x nodes x 3], y up, metres
 */

const FORMAT = "vcgpdm-first-motion/1";
/** A quarter of a millimetre: finer than a pixel on any screen. */
const UNIT = 0.00025;
const LIMIT = 32767;

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
  const { frames, frameTime, figure, joints, parts } = motion;
  let header = JSON.stringify({ format: FORMAT, unit: UNIT, frames, frameTime, figure, joints, parts });
  const encoder = new TextEncoder();
  if (encoder.encode(header).length % 2 === 1) header += " ";
  const head = encoder.encode(header);
  const bytes = new Uint8Array(4 + head.length + 2 * motion.positions.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, head.length, true);
  bytes.set(head, 4);
  const before = new Int32Array(width);
  for (let i = 0; i < motion.positions.length; i++) {
    const now = Math.round((motion.positions[i] ?? 0) / UNIT);
    const step = now - (before[i % width] ?? 0);
    if (!(Math.abs(step) <= LIMIT)) throw new Error(`coordinate ${i} jumps by ${step * UNIT} metres`);
    view.setInt16(4 + head.length + 2 * i, step, true);
    before[i % width] = now;
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
  const now = new Int32Array(width);
  for (let i = 0; i < count; i++) {
    const value = (now[i % width] ?? 0) + view.getInt16(4 + length + 2 * i, true);
    now[i % width] = value;
    positions[i] = value * header.unit;
  }
  const { frames, frameTime, figure, joints, parts } = header;
  return { frames, frameTime, figure, joints, parts, positions };
}
