// The stores of the view Primitives.
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import type { WholeWorkers } from "../engine/whole-workers";
import type { SettingsStore } from "../settings/settings-store";
import type { NoticesStore } from "../ui/notices-store";
import { prefersReducedMotion } from "../ui/reduced-motion";
import { fetchLibrary } from "./first-library";
import { FittingStore } from "./fitting-store";
import { FoldStore } from "./fold-store";
import { ImportStore } from "./import-store";
import { LearningStore } from "./learning-store";
import { LibraryStore } from "./library-store";
import { LockingStore } from "./locking-store";
import { RecordedStore } from "./recorded-store";
import { RecognitionStore } from "./recognition-store";

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
  library.walk.player.playing = !prefersReducedMotion();
  return {
    library,
    fitting: new FittingStore(whole, clips, library),
    imports: new ImportStore(whole, clips, library),
    /** The seed of the settings. */
    seed: () => settings.values.seed,
    locking: new LockingStore(whole, library),
    learning: new LearningStore(whole, engine, settings, clips, library),
    fold: new FoldStore(whole, engine),
    recorded: new RecordedStore(whole, clips, fetchLibrary),
    recognition: new RecognitionStore(whole, clips, library),
  };
}
