// One participation in a study: the participant, the trials and the rows of answers. No rendering.
import type { StudyInfo } from "../engine/whole-protocol";

/** A row of data of jsPsych, with our columns. */
export type Row = Record<string, unknown>;

/** A participation before its first answer. */
export interface Participation {
  /** No other participation on this machine has it. */
  key: string;
  /** When it began, in milliseconds since 1970; only the list on the page uses it, no file. */
  at: number;
  /** The participant's code in the files; not a name. */
  participant: string;
  /** Of the draw of the trials and their order. */
  seed: number;
  /** The study's hash and title. */
  study: string;
  title: string;
  /** The number of trials. */
  trials: number;
  /** Whether the program gives the answers, to try the experiment out. */
  simulated: boolean;
}

/** A participation with its rows of answers so far. */
export interface StoredParticipation extends Participation {
  rows: readonly Row[];
}

/** The participations that this browser stores. */
export interface AnswerDatabase {
  all(): Promise<StoredParticipation[]>;
  /** The text of a participation's study. */
  study(key: string): Promise<string | null>;
  begin(participation: Participation, study: string): Promise<void>;
  /** Stores a row; its place is counted from 0. */
  add(key: string, place: number, row: Row): Promise<void>;
  forget(key: string): Promise<void>;
  /** Takes a participation for this tab until the returned function is called; null: another tab has it. */
  hold(key: string): Promise<(() => void) | null>;
}

const isAnswer = ({ kind }: Row) => typeof kind === "string" && kind !== "";

/** The number of answered trials. */
export const answered = ({ rows }: StoredParticipation): number => rows.filter(isAnswer).length;

export const isComplete = (participation: StoredParticipation): boolean =>
  answered(participation) >= participation.trials;

/** How often the participant has begun or continued the experiment. */
export const sessionCount = ({ rows }: StoredParticipation): number =>
  Math.max(0, ...rows.map(({ sitting }) => Number(sitting) || 0));

/** Letters and digits without those that look alike. */
const SIGNS = "23456789abcdefghjkmnpqrstuvwxyz";

const drawn = (count: number) => [...crypto.getRandomValues(new Uint32Array(count))];

/** A random code. */
export const newName = (): string =>
  drawn(6).reduce((name, number) => name + SIGNS[number % SIGNS.length], "");

/** The name, with a number after it when it is taken: files know participants by their names. */
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

/** The columns that are equal in all rows of one session. */
export const columnsOf = ({ participant, study, seed, simulated }: Participation, sitting: number): Row => ({
  participant,
  study,
  seed,
  simulated,
  sitting,
});
