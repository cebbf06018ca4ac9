// For tests: the English words of the Lab and of its views.
import { loadCompare } from "./compare";
import { loadExperiment } from "./experiment";
import { loadHelp } from "./help";
import { loadLab } from "./lab";
import { loadMethod } from "./method";
import { loadNumbers } from "./numbers";
import { loadPerception } from "./perception";
import { loadPrimitives } from "./primitives";
import { loadSeries } from "./series";
import { loadSession } from "./session";
import type { WordsStore } from "./words";

const english = { language: "en", on: () => () => {} } as unknown as WordsStore;
for (const load of [
  loadLab,
  loadCompare,
  loadExperiment,
  loadHelp,
  loadMethod,
  loadNumbers,
  loadPerception,
  loadPrimitives,
  loadSeries,
  loadSession,
])
  await load(english);
