// The explanations of terms. They load when the first term is asked about, in the language of the document.
import type { TermsWords } from "./en/terms";

export async function termWords(language = document.documentElement.lang): Promise<TermsWords> {
  return language === "de" ? (await import("./de/terms")).terms : (await import("./en/terms")).terms;
}
