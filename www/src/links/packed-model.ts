// A model's document as text in a link: "1.LENGTH.DATA". DATA is the document with fewer digits, half of each
// symmetric matrix left out, deflated with a check number (zlib), in base64url; LENGTH counts its characters.
import { LARGEST_DOCUMENT, textWithin } from "./bytes";
import { shortened } from "./digits.js";
import { LinkError } from "./problem";

/** The form that this version writes and reads. */
const FORM = "1";
/** Characters of the longest link. Browsers open addresses up to a million characters. */
export const LONGEST = 200_000;

/**
 * The sums from which experts are inferred again need more digits than other numbers: with seven and nine, the
 * joints of a re-inferred walk move by centimetres, with twelve by a millimetre (packed-model.test.ts). Latents
 * and coefficients of MAP models need nine: with seven, joints move by four millimetres.
 */
const DIGITS = {
  u_covariance: 2,
  ...{ sum_psi2: 12, sum_psi1_mu: 12, other_precision: 12, other_b: 12 },
  ...{ latents: 9, coefficients: 9 },
};

const SYMMETRIC: ReadonlySet<string> = new Set([
  "v_covariance",
  "u_covariance",
  "sum_psi2",
  "other_precision",
]);

/** The text of a model's document for a link. */
export async function packed(document: string): Promise<string> {
  const shorter: unknown = shortened(JSON.parse(document), DIGITS);
  const text = JSON.stringify(shorter, (name, value) => (SYMMETRIC.has(name) ? lowerHalf(value) : value));
  const data = base64url(await deflated(text));
  const whole = `${FORM}.${data.length}.${data}`;
  if (whole.length > LONGEST) throw new LinkError({ what: "long", most: LONGEST, found: whole.length });
  return whole;
}

/** The document of the model in a link, for the reader of model files. Throws a `LinkError`. */
export async function unpacked(text: string): Promise<string> {
  if (text.length > LONGEST) throw new LinkError({ what: "long", most: LONGEST, found: text.length });
  const [, form = text.split(".", 1)[0] ?? "", length, data = ""] =
    /^(\w+)\.(\d{1,9})(?:\.(.*))?$/s.exec(text) ?? [];
  if (form !== FORM) throw new LinkError({ what: "version", expected: FORM, found: form.slice(0, 20) });
  if (length === undefined) throw new LinkError({ what: "damaged" });
  if (data.length !== Number(length))
    throw new LinkError({ what: "cut", expected: Number(length), found: data.length });
  const document = await inflated(bytesOf(data));
  const whole = withBothHalves(document);
  if (whole.length > LARGEST_DOCUMENT) throw new LinkError({ what: "large", most: LARGEST_DOCUMENT });
  return whole;
}

function withBothHalves(document: string): string {
  try {
    const whole = JSON.parse(document, (name, value) => (SYMMETRIC.has(name) ? bothHalves(value) : value));
    return JSON.stringify(whole);
  } catch {
    // The reader of models says where the document is wrong.
    return document;
  }
}

/** Rows of a symmetric matrix up to the diagonal; other values stay. */
function lowerHalf(value: unknown): unknown {
  if (!isSquare(value)) return value;
  const isSymmetric = value.every((row, i) => row.every((entry, j) => entry === value[j]?.[i]));
  return isSymmetric ? value.map((row, i) => row.slice(0, i + 1)) : value;
}

const isSquare = (value: unknown): value is unknown[][] =>
  Array.isArray(value) && value.every((row) => Array.isArray(row) && row.length === value.length);

/**
 * A matrix from its rows up to the diagonal; other values stay, for the reader of models to judge. An entry that
 * holds a matrix itself would be written twice at each level.
 */
function bothHalves(value: unknown): unknown {
  const isRow = (row: unknown, i: number) =>
    Array.isArray(row) && row.length === i + 1 && row.every((entry) => typeof entry === "number");
  if (!Array.isArray(value) || !value.every(isRow)) return value;
  return value.map((row, i) => value.map((other, j) => (j <= i ? row[j] : other[i])));
}

async function deflated(text: string): Promise<Uint8Array> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  if (typeof DecompressionStream !== "function") throw new LinkError({ what: "browser" });
  try {
    return await textWithin(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
  } catch (problem) {
    throw problem instanceof LinkError ? problem : new LinkError({ what: "damaged" });
  }
}

function base64url(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function bytesOf(data: string): Uint8Array<ArrayBuffer> {
  const place = data.search(/[^\w-]/);
  if (place >= 0) throw new LinkError({ what: "character", found: data.charAt(place), place: place + 1 });
  // No number of bytes has this many characters.
  if (data.length % 4 === 1) throw new LinkError({ what: "damaged" });
  const binary = atob(data.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
