// The recordings that can give a part of the model, and what the model infers of them.
import type { ClipsStore } from "../clips/clips-store";
import { ModelDocument } from "../couplings/model-document";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { ClipSource, LiveBody, ModelView } from "../engine/protocol";
import type { CompletedClip, CompletionRequest } from "../engine/whole-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { Store } from "../ui/store";
import { completingWords } from "../words/sections";

export interface Recording {
  key: string;
  title: string;
  /** Null: the walk of the model under its learned couplings, as if it were recorded. */
  source: ClipSource | null;
  /** The frames to use: first up to, not including, end. */
  first: number;
  end: number;
  /** Seconds between frames. */
  frameTime: number;
}

/** The request in which a part is given throughout, under the learned couplings. */
export const observed = (
  { parts }: Pick<LiveBody, "parts">,
  part: number,
): Omit<CompletionRequest, "clip"> => ({
  given: parts[part]?.name ?? "",
  until: null,
  alpha: null,
  reading: "as-learned",
});

/** The open clips of a body, as recordings. */
export const recordingsOf = (clips: ClipsStore, joints: LiveBody["joints"]): Recording[] =>
  clips.ofBody(joints).map(({ key, title, source, first, end, loaded }) => ({
    ...{ key, title, source, first, end },
    frameTime: loaded.info.frameTime,
  }));

/** It changes with the model and the open clips. */
export class Recordings extends Store {
  readonly #document: ModelDocument;

  constructor(
    private readonly engine: EngineStore,
    private readonly model: ModelStore,
    private readonly clips: ClipsStore,
    workers: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#document = new ModelDocument(engine, workers);
    model.on(() => this.changed());
    clips.on(() => this.changed());
  }

  /** The clips of the model's body, and the model's own walk. */
  get all(): readonly Recording[] {
    const { learned, model } = this.model;
    if (!model || !learned) return [];
    const { frames, frameTime } = learned.motion;
    const title = completingWords().ownWalk;
    const own = { key: "own-motion", title, source: null, first: 0, end: frames, frameTime };
    return [...recordingsOf(this.clips, model.info.joints), own];
  }

  /** Changes with the model. */
  get revision(): number {
    return this.model.model?.revision ?? 0;
  }

  /** Lets the model observe one part of a recording, under its learned couplings. */
  async infer(part: number, recording: Recording): Promise<CompletedClip> {
    const { model } = this.model;
    if (!model) throw new Error(completingWords().notReady);
    return this.complete(model, recording, observed(model.info, part));
  }

  /** Lets the model observe one part of a recording and infer the others. */
  async complete(
    model: ModelView,
    { source, first, end }: Recording,
    request: Omit<CompletionRequest, "clip">,
  ): Promise<CompletedClip> {
    const { engine } = this.engine;
    const { learned } = this.model;
    if (!engine || !learned) throw new Error(completingWords().notReady);
    const read = source ?? {
      name: "walk.bvh",
      file: new Blob([await engine.rolloutBvh(learned.request)]),
    };
    return this.#document.ask(model.revision, (worker) =>
      worker.complete({ ...request, clip: { id: 0, source: read, first, end } }),
    );
  }
}
