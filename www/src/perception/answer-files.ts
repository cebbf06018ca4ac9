// Answers as files: jsPsych's CSV with all rows of one or more participants, and the same as JSON.
import { DataCollection } from "jspsych";
import type { AnswersFile } from "../engine/whole-protocol";
import { guarded } from "../figures/csv";
import type { StoredParticipation, Row } from "./participation";

const rowsOf = (participations: readonly StoredParticipation[]) =>
  new DataCollection(participations.flatMap(({ rows }) => rows.map((row) => ({ ...row }))));

/** A name that every file system accepts. */
const plain = (name: string) => name.replace(/[^\p{L}\p{N}._-]+/gu, "-");

const baseOf = (participations: readonly StoredParticipation[]) => {
  const [only, ...others] = participations;
  return only && others.length === 0 ? `answers-${plain(only.participant)}` : "answers";
};

const guardedRow = (row: Row): Row =>
  Object.fromEntries(
    Object.entries(row).map(([name, value]) => [name, typeof value === "string" ? guarded(value) : value]),
  );

export function csvFile(participations: readonly StoredParticipation[]): AnswersFile {
  const guardedRows = participations.map((participation) => ({
    ...participation,
    rows: participation.rows.map(guardedRow),
  }));
  return { name: `${baseOf(participations)}.csv`, text: rowsOf(guardedRows).csv() };
}

export function jsonFile(participations: readonly StoredParticipation[]): AnswersFile {
  return { name: `${baseOf(participations)}.json`, text: rowsOf(participations).json() };
}
