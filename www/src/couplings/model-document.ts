// The open model in a worker of the whole program. Its document is made once, and sent once to a worker.
import type { EngineStore } from "../engine/engine-store";
import { OpenDocument } from "../engine/open-document";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { lab } from "../words/lab";

export class ModelDocument {
  readonly #document: OpenDocument<WholeCalls, void>;
  /** The document of the model of this revision. */
  #text: { revision: number; text: Promise<string> } | null = null;

  constructor(
    private readonly engine: EngineStore,
    { desk }: Pick<WholeWorkers, "desk">,
  ) {
    this.#document = new OpenDocument(desk, (worker, text) => worker.openOutlook(text));
  }

  /** Makes a call to a worker that has the model of this revision open. */
  async ask<Answer>(revision: number, call: (worker: WholeCalls) => Promise<Answer>): Promise<Answer> {
    return this.#document.ask(await this.#textOf(revision), call);
  }

  #textOf(revision: number): Promise<string> {
    const { engine } = this.engine;
    if (!engine) throw new Error(lab().learn.training.whyNot.cannotRun);
    if (this.#text?.revision !== revision) this.#text = { revision, text: engine.modelJson() };
    return this.#text.text;
  }
}

const OTHER_KIND = /"kind"\s*:\s*"(map-gpdm|map-cgpdm|tmp|dmp-discrete|dmp-rhythmic)"/;

/** The key of their motion on the stage; keys of clips begin with "made-" or "own-". */
export const OTHER_MODEL = "other-model";

export const hasNoCouplings = (document: string): boolean => OTHER_KIND.test(document);
