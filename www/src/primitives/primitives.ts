// The stores of the view Primitives.
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import type { WholeWorkers } from "../engine/whole-workers";
import type { SettingsStore } from "../settings/settings-store";
import type { NoticesStore } from "../ui/notices-store";
import { prefersReducedMotion } from "../ui/browser";
import { FittingStore } from "./fitting-store";
import { LearningStore } from "./learning-store";
import { LibraryRecordings } from "./library-recordings";
import { LibraryStore } from "./library-store";
import { RecordedParts } from "../live/recorded-parts";
import { RecordedStore } from "./recorded-store";
import { RecognitionStore } from "./recognition-store";
import { lab } from "../words/lab";

/** Its document. */
async function fetchLibrary(): Promise<string> {
  const answer = await fetch(new URL("primitives/library.json", document.baseURI));
  if (!answer.ok) throw new Error(lab().files.hostAnswered(answer.status, answer.url));
  return answer.text();
}

/** All stores of the view, and the seed of the settings. */
export type Primitives = ReturnType<typeof openPrimitives>;

export function openPrimitives(
  whole: WholeWorkers,
  engine: EngineStore,
  settings: SettingsStore,
  clips: ClipsStore,
  notices: NoticesStore,
) {
  const library = new LibraryStore(whole, notices, fetchLibrary);
  // Later visits of the view continue as the visitor left it.
  if (!prefersReducedMotion()) library.playback.play();
  return {
    library,
    recordedParts: new RecordedParts(new LibraryRecordings(library, clips, whole), library.walk, notices),
    fitting: new FittingStore(whole, clips, library),
    learning: new LearningStore(whole, engine, settings, clips, library),
    recorded: new RecordedStore(whole, clips, fetchLibrary),
    recognition: new RecognitionStore(whole, clips, library),
  };
}
