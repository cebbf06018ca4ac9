// The study that comes with the page. A host of the page may replace its file.
import { lab } from "../words/lab";

export const STUDY_OF_THE_PAGE = "study/walks.study.json";

export async function studyOfThePage(): Promise<string> {
  const answer = await fetch(new URL(STUDY_OF_THE_PAGE, document.baseURI));
  if (!answer.ok) throw new Error(lab().files.hostAnswered(answer.status, answer.url));
  return answer.text();
}
