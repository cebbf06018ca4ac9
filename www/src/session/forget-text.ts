// The sentences about what "Forget everything" removes.
import type { AnswerCounts } from "./answer-database";

interface Forgettable {
  contents: string;
  earlierVisits: number;
}

const counted = (count: number, singular: string, plural: string) =>
  count === 1 ? singular : `${count} ${plural}`;

const answersText = ({ participants, answers }: AnswerCounts) =>
  `${counted(answers, "the answer", "answers")} of ${counted(participants, "a participant", "participants")} on this machine`;

/** What is stored, piece by piece. `answers`: null when they could not be counted. */
function pieces({ contents, earlierVisits }: Forgettable, answers: AnswerCounts | null): string[] {
  const earlier =
    earlierVisits === 0
      ? ""
      : ` (of this visit and ${counted(earlierVisits, "an earlier one", "earlier ones")})`;
  return [
    ...(contents === "" ? [] : [`${contents}${earlier}`]),
    ...(answers === null ? ["all answers of participants on this machine"] : []),
    ...(answers && answers.participants > 0 ? [answersText(answers)] : []),
  ];
}

/** "This removes 2 clips and a training, and 60 answers of 3 participants on this machine." */
export function lossText(forgettable: Forgettable, answers: AnswerCounts | null): string {
  const stored = pieces(forgettable, answers);
  return stored.length === 0
    ? "This browser stores nothing of your visits yet. It then stores nothing of this visit either."
    : `This removes ${stored.join(", and ")} from this browser. It then stores nothing of this visit either.`;
}

/** The same when it has happened. */
export function forgottenText(forgettable: Forgettable, answers: AnswerCounts | null): string {
  const stored = pieces(forgettable, answers);
  const what = stored.length === 0 ? "" : `: ${stored.join(", and ")}`;
  return `Forgotten${what}. It comes back only with Undo, and only until you leave the page.`;
}
