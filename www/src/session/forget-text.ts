// The sentences about what "Forget everything" removes.
import { sessionWords } from "../words/session";
import type { AnswerCounts } from "./answer-database";

interface Forgettable {
  contents: string;
  earlierVisits: number;
}

/** What is stored, piece by piece. `answers`: null when they could not be counted. */
function pieces({ contents, earlierVisits }: Forgettable, answers: AnswerCounts | null): string[] {
  const words = sessionWords();
  return [
    ...(contents === "" ? [] : [words.ofVisits(contents, earlierVisits)]),
    ...(answers === null ? [words.allAnswers] : []),
    ...(answers && answers.participants > 0 ? [words.answers(answers.answers, answers.participants)] : []),
  ];
}

/** "This removes 2 clips and a training, and 60 answers of 3 participants on this machine." */
export function lossText(forgettable: Forgettable, answers: AnswerCounts | null): string {
  const stored = pieces(forgettable, answers);
  const { storesNothing, removes } = sessionWords();
  return stored.length === 0 ? storesNothing : removes(stored);
}

/** The same when it has happened. */
export const forgottenText = (forgettable: Forgettable, answers: AnswerCounts | null): string =>
  sessionWords().forgotten(pieces(forgettable, answers));
