// The stores of the view Primitives.
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { observed, type Recording, recordingsOf } from "../completing/recordings";
import { OpenDocument } from "../engine/open-document";
import type { CompletedClip } from "../engine/whole-protocol";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { Store } from "../ui/store";
import { completingWords } from "../words/sections";
import type { SettingsStore } from "../settings/settings-store";
import type { NoticesStore } from "../ui/notices-store";
import { prefersReducedMotion } from "../ui/browser";
import { FittingStore } from "./fitting-store";
import { LearningStore } from "./learning-store";
import { LibraryStore } from "./library-store";
import { RecordedParts } from "../live/recorded-parts";
import { RecordedStore } from "./recorded-store";
import { RecognitionStore } from "./recognition-store";
import { lab } from "../words/lab";

/** The recordings that can move a part of the combination, and what the combination infers of them. */
class LibraryRecordings extends Store {
  readonly #document: OpenDocument<WholeCalls, void>;

  constructor(
    private readonly library: LibraryStore,
    private readonly clips: ClipsStore,
    { desk }: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#document = new OpenDocument(desk, (worker, text) => worker.openOutlook(text));
    clips.on(() => this.changed());
  }

  get all(): readonly Recording[] {
    const { current } = this.library;
    return current ? recordingsOf(this.clips, current.info.joints) : [];
  }

  get revision(): number {
    return this.library.revision;
  }

  async infer(part: number, { source, first, end }: Recording): Promise<CompletedClip> {
    const { current } = this.library;
    if (!current || !source) throw new Error(completingWords().notReady);
    const request = { ...observed(current.info, part), clip: { id: 0, source, first, end } };
    return this.#document.ask(await this.library.combinationText(), (worker) => worker.complete(request));
  }
}

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
