// The answers of a participant as one short code, which a class can read out or paste as a column. The code
// has the seed, from which the trials follow, and a bit for each answer; it has no times.
import { messageOf } from "../ui/format";
import { perceptionWords } from "./view-words";
import type { Row } from "./participation";
import type { Side } from "./trial-view";

/** Digits of Crockford's base 32, which has no i, l, o and u. */
const SIGNS = "0123456789abcdefghjkmnpqrstvwxyz";
const BITS = 5;
/** Signs between two hyphens. */
const GROUP = 5;
/** The last byte tells most mistyped codes. */
const CHECK = 0x1d;
/** More answers make no short code. */
export const MOST_ANSWERS = 100;
/** The bytes before the answers: two of the study's hash, four of the seed, one of the number of answers. */
const HEAD = 7;
/** In the byte with the number of answers. */
const SIMULATED = 0x80;

export interface CodedAnswers {
  seed: number;
  simulated: boolean;
  answers: readonly Side[];
}

function checkOf(bytes: readonly number[]): number {
  let check = 0;
  for (const byte of bytes) {
    check ^= byte;
    for (let bit = 0; bit < 8; bit++) check = check & 0x80 ? ((check << 1) ^ CHECK) & 0xff : check << 1;
  }
  return check;
}

/** The first two bytes of the study's hash. */
const studyBytes = (hash: string) => [0, 2].map((at) => Number.parseInt(hash.slice(at, at + 2), 16) || 0);

/** The code of answers to the study of this hash; null: too many for a short code, or none. */
export function codeOf(hash: string, { seed, simulated, answers }: CodedAnswers): string | null {
  if (answers.length === 0 || answers.length > MOST_ANSWERS) return null;
  const bytes = studyBytes(hash);
  for (const shift of [24, 16, 8, 0]) bytes.push((seed >>> shift) & 0xff);
  bytes.push(answers.length | (simulated ? SIMULATED : 0));
  for (let first = 0; first < answers.length; first += 8)
    bytes.push(
      answers.slice(first, first + 8).reduce((byte, side, bit) => byte | (Number(side === "left") << bit), 0),
    );
  bytes.push(checkOf(bytes));
  const signs = signsOf(bytes);
  return signs.match(new RegExp(`.{1,${GROUP}}`, "g"))?.join("-") ?? null;
}

function signsOf(bytes: readonly number[]): string {
  const bits = bytes.map((byte) => byte.toString(2).padStart(8, "0")).join("");
  return (bits.match(new RegExp(`.{1,${BITS}}`, "g")) ?? [])
    .map((five) => SIGNS[Number.parseInt(five.padEnd(BITS, "0"), 2)])
    .join("");
}

/** The answers of a code to the study of this hash. Throws when the code is mistyped or of another study. */
export function readCode(hash: string, code: string): CodedAnswers {
  const signs = code.toLowerCase().replace(/[\s-]/g, "").replaceAll("o", "0").replace(/[il]/g, "1");
  const wrong = [...signs].find((sign) => !SIGNS.includes(sign));
  if (wrong !== undefined) throw new Error(perceptionWords().codes.sign(wrong));
  const bits = [...signs].map((sign) => SIGNS.indexOf(sign).toString(2).padStart(BITS, "0")).join("");
  const all = (bits.match(/.{8}/g) ?? []).map((byte) => Number.parseInt(byte, 2));
  const count = (all[HEAD - 1] ?? 0) & ~SIMULATED;
  const length = HEAD + Math.ceil(count / 8);
  if (count === 0 || all.length !== length + 1 || checkOf(all.slice(0, length)) !== all[length])
    throw new Error(perceptionWords().codes.notWhole);
  if (studyBytes(hash).some((byte, at) => byte !== all[at]))
    throw new Error(perceptionWords().codes.otherStudy);
  const seed = all.slice(2, HEAD - 1).reduce((sum, byte) => sum * 256 + byte, 0);
  const answers = Array.from({ length: count }, (_, place): Side => {
    const byte = all[HEAD + Math.floor(place / 8)] ?? 0;
    return (byte >> (place % 8)) & 1 ? "left" : "right";
  });
  return { seed, simulated: ((all[HEAD - 1] ?? 0) & SIMULATED) > 0, answers };
}

/** The answers among the rows of a participant, in their order; null: one is missing. */
export function answersOf(rows: readonly Row[]): Side[] | null {
  const responses = rows
    .filter(({ kind }) => typeof kind === "string" && kind !== "")
    .map(({ response }) => response);
  return responses.every((response): response is Side => response === "left" || response === "right")
    ? responses
    : null;
}

/** The codes of a text, one in each line, each once. Throws with the line of a code that cannot be read. */
export function codesOf(hash: string, text: string): CodedAnswers[] {
  const bySeed = new Map<number, CodedAnswers>();
  text.split("\n").forEach((line, i) => {
    if (line.trim() === "") return;
    try {
      const coded = readCode(hash, line);
      bySeed.set(coded.seed, coded);
    } catch (problem) {
      throw new Error(perceptionWords().codes.line(i + 1, messageOf(problem)));
    }
  });
  return [...bySeed.values()];
}
