import { defineView } from "../views/define-view";
import type { AnalysisStore } from "./analysis-store";
import type { PerceptionStore } from "./perception-store";
import { words } from "./view-words";

declare module "../settings/views" {
  interface ViewStores {
    perception: { perception: PerceptionStore; analysis: AnalysisStore };
  }
}

/** Answers in the browser's database; null: the browser stores nothing, and the experiment works all the same. */
const database = () =>
  import("./answer-database").then(({ answerDatabase }) => answerDatabase()).catch(() => null);

export const view = defineView({
  name: "perception",
  budget: 54_000,
  place: 4,
  words: {
    en: {
      name: "Which is natural?",
      lead: "The graphics Turing test: can people tell a model’s movement from a natural one?",
    },
    de: {
      name: "Was ist natürlich?",
      lead: "Der grafische Turing-Test: Unterscheiden Menschen die Bewegung eines Modells von einer natürlichen?",
    },
  },
  async stores({ workers, words: language }) {
    const [{ PerceptionStore }, { AnalysisStore }, { studyOfThePage }, stored] = await Promise.all([
      import("./perception-store"),
      import("./analysis-store"),
      import("./study-of-the-page"),
      database(),
      words.load(language),
    ]);
    return {
      perception: new PerceptionStore(workers, stored, studyOfThePage),
      analysis: new AnalysisStore(workers),
    };
  },
});
