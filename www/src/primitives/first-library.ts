// The library that comes with the page.
import { lab } from "../words/lab";

/** Its document. */
export async function fetchLibrary(): Promise<string> {
  const answer = await fetch(new URL("primitives/library.json", document.baseURI));
  if (!answer.ok) throw new Error(lab().files.hostAnswered(answer.status, answer.url));
  return answer.text();
}
