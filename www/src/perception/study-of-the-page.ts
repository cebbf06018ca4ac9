// The study that comes with the page; whoever hosts the page puts another in its place.
export const STUDY_OF_THE_PAGE = "study/walks.study.json";

export async function studyOfThePage(): Promise<string> {
  const answer = await fetch(new URL(STUDY_OF_THE_PAGE, document.baseURI));
  if (!answer.ok) throw new Error(`the host answered ${answer.status} for ${answer.url}`);
  return answer.text();
}
