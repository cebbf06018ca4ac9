// One participant's way through a study: who, which trials, and the rows of answers so far. No rendering.
import type { StudyInfo } from "../engine/whole-protocol";

/** A row of data as jsPsych writes it, with our columns. */
export type Row = Record<string, unknown>;

/** What is known of a participation before its first answer. */
export interface Participation {
  /** Tells it from all others on this machine. */
  key: string;
  /** When it began, milliseconds since 1970: only to put them in order here, in no file. */
  at: number;
  /** What the participant is called in the files: nothing that tells who it is. */
  participant: string;
  /** Which trials, in which order. */
  seed: number;
  /** The study's hash and title. */
  study: string;
  title: string;
  /** How many trials there are. */
  trials: number;
  /** Whether the program itself answers, to try the experiment out. */
  simulated: boolean;
}

/** With the rows of answers so far. */
export interface KeptParticipation extends Participation {
  rows: readonly Row[];
}

/** Where participations are kept, on this machine. */
export interface AnswerShelf {
  all(): Promise<KeptParticipation[]>;
  /** The text of a participation's study. */
  study(key: string): Promise<string | null>;
  begin(participation: Participation, study: string): Promise<void>;
  /** Keeps the row in that place. */
  add(key: string, place: number, row: Row): Promise<void>;
  forget(key: string): Promise<void>;
  /** Keeps other tabs from a participation until the answer is called; null: another tab has it. */
  hold(key: string): Promise<(() => void) | null>;
}

const isAnswer = ({ kind }: Row) => typeof kind === "string" && kind !== "";

/** How many trials are answered. */
export const answered = ({ rows }: KeptParticipation): number => rows.filter(isAnswer).length;

export const isComplete = (participation: KeptParticipation): boolean =>
  answered(participation) >= participation.trials;

/** How often the participant has sat down to it. */
export const sittings = ({ rows }: KeptParticipation): number =>
  Math.max(0, ...rows.map(({ sitting }) => Number(sitting) || 0));

/** Letters and digits, without those that look like others. */
const SIGNS = "23456789abcdefghjkmnpqrstuvwxyz";

const drawn = (count: number) => [...crypto.getRandomValues(new Uint32Array(count))];

/** A name at random. */
export const newName = (): string =>
  drawn(6).reduce((name, number) => name + SIGNS[number % SIGNS.length], "");

/**
 * The name, or, where somebody is called so already, with a number after it: a file tells participants apart
 * by their names.
 */
export function freeName(name: string, taken: ReadonlySet<string>): string {
  let free = name;
  for (let number = 2; taken.has(free); number++) free = `${name}-${number}`;
  return free;
}

export function newParticipation(
  { hash, title }: StudyInfo,
  about: Pick<Participation, "participant" | "trials" | "seed" | "simulated">,
): Participation {
  return { key: newName() + newName(), at: Date.now(), study: hash, title, ...about };
}

export const newSeed = (): number => drawn(1)[0] ?? 0;

/** The columns that are the same in all rows of a participation. */
export const columnsOf = ({ participant, study, seed, simulated }: Participation, sitting: number): Row => ({
  participant,
  study,
  seed,
  simulated,
  sitting,
});
