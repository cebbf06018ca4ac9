// Answers as files: jsPsych's CSV with all rows of one or more participants, and the same as JSON.
import { DataCollection } from "jspsych";
import type { AnswersFile } from "../engine/whole-protocol";
import type { KeptParticipation } from "./participation";

const rowsOf = (participations: readonly KeptParticipation[]) =>
  new DataCollection(participations.flatMap(({ rows }) => rows.map((row) => ({ ...row }))));

/** Letters, digits and the like: what a file may be called anywhere. */
const plain = (name: string) => name.replace(/[^\p{L}\p{N}._-]+/gu, "-");

const baseOf = (participations: readonly KeptParticipation[]) => {
  const [only, ...others] = participations;
  return only && others.length === 0 ? `answers-${plain(only.participant)}` : "answers";
};

export function csvFile(participations: readonly KeptParticipation[]): AnswersFile {
  return { name: `${baseOf(participations)}.csv`, text: rowsOf(participations).csv() };
}

export function jsonFile(participations: readonly KeptParticipation[]): AnswersFile {
  return { name: `${baseOf(participations)}.json`, text: rowsOf(participations).json() };
}
