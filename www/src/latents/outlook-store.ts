// What may come: sampled futures of the rollout on the stage, and what a Gaussian knows of its latents.
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { RolloutRequest, RolloutResult } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { PartMoments } from "../engine/whole-protocol";
import type { StageStore } from "../stage/stage-store";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { sameTimes } from "../couplings/same-times";

export const FUTURES = 5;

/** What of it is shown: motions drawn at random, or the band of moment matching. */
export type Outlook = "futures" | "uncertainty";

/** Moments, and of which rollout they are. */
interface Known {
  revision: number;
  request: RolloutRequest;
  parts: PartMoments[];
}

export class OutlookStore extends Store {
  readonly #engine: EngineStore;
  readonly #model: ModelStore;
  readonly #stage: StageStore;
  readonly #notices: NoticesStore;
  readonly #whole: Pick<WholeWorkers, "desk">;
  readonly #shown = new Set<Outlook>();
  /** The document of the model of this revision. */
  #text: { revision: number; text: Promise<string> } | null = null;
  #seed = 1;
  #futures: RolloutResult[] = [];
  #moments: Known | null = null;
  /** The rollout that was asked about last. */
  #asked: RolloutResult | null = null;
  readonly #futuresAsked: Latest<{ rollout: RolloutResult; seed: number }, RolloutResult[]>;
  readonly #momentsAsked: Latest<RolloutResult, Known>;

  /** `whole`: its workers match moments. */
  constructor(
    engine: EngineStore,
    model: ModelStore,
    stage: StageStore,
    notices: NoticesStore,
    whole: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#engine = engine;
    this.#model = model;
    this.#stage = stage;
    this.#notices = notices;
    this.#whole = whole;
    this.#futuresAsked = new Latest(
      async ({ rollout, seed }) => (await engine.engine?.futures(rollout.request, FUTURES, seed)) ?? [],
      (futures, { seed }) => {
        if (seed === this.#seed) this.#takeFutures(futures);
      },
      (problem) => this.#fail("futures", problem),
    );
    this.#momentsAsked = new Latest(
      (rollout) => this.#match(rollout),
      (moments) => this.#takeMoments(moments),
      (problem) => this.#fail("uncertainty", problem),
    );
    model.on(() => {
      if (model.rollout !== this.#asked) this.#ask();
    });
  }

  isShown(outlook: Outlook): boolean {
    return this.#shown.has(outlook);
  }

  /** The seed of the first future; those of the others follow it. */
  get seed(): number {
    return this.#seed;
  }

  get futures(): readonly RolloutResult[] {
    return this.#futures;
  }

  /** Of each part; null until they are known. */
  get moments(): readonly PartMoments[] | null {
    return this.#moments?.parts ?? null;
  }

  show(outlook: Outlook, shown: boolean): void {
    if (shown) this.#shown.add(outlook);
    else this.#shown.delete(outlook);
    this.#ask();
    this.changed();
  }

  /** Draws others, of the next seeds. */
  drawOthers(): void {
    this.#seed += FUTURES;
    this.#ask();
    this.changed();
  }

  /** Asks about the rollout on the stage for what is shown, and drops what does not belong to it. */
  #ask(): void {
    const { rollout } = this.#model;
    this.#asked = rollout;
    const stays = (known: { revision: number; request: RolloutRequest } | null | undefined) =>
      rollout && known && known.revision === rollout.revision && sameTimes(known.request, rollout.request);
    if (!rollout || !this.isShown("futures") || (this.#futures.length > 0 && !stays(this.#futures[0])))
      this.#takeFutures([]);
    if (!rollout || !this.isShown("uncertainty") || !stays(this.#moments)) this.#takeMoments(null);
    if (rollout && this.isShown("futures")) this.#futuresAsked.request({ rollout, seed: this.#seed });
    else this.#futuresAsked.drop();
    if (rollout && this.isShown("uncertainty")) this.#momentsAsked.request(rollout);
    else this.#momentsAsked.drop();
  }

  async #match({ revision, request }: RolloutResult): Promise<Known> {
    const text = await this.#textOf(revision);
    return {
      revision,
      request,
      parts: await this.#whole.desk.run((worker) => worker.moments(text, request)),
    };
  }

  #textOf(revision: number): Promise<string> {
    const { engine } = this.#engine;
    if (!engine) throw new Error("The model cannot run in this browser.");
    if (this.#text?.revision !== revision) this.#text = { revision, text: engine.modelJson() };
    return this.#text.text;
  }

  #takeFutures(futures: RolloutResult[]): void {
    if (futures.length === 0 && this.#futures.length === 0) return;
    // The worker may have taken up another model that the page does not know yet.
    const current = futures[0]?.revision === this.#model.model?.revision;
    this.#futures = current ? futures : [];
    this.#stage.setFutures(this.#futures.map(({ motion }) => motion));
    this.changed();
  }

  #takeMoments(moments: Known | null): void {
    if (moments === this.#moments) return;
    this.#moments = moments && moments.revision === this.#model.model?.revision ? moments : null;
    this.changed();
  }

  #fail(outlook: Outlook, problem: unknown): void {
    this.#shown.delete(outlook);
    this.#ask();
    this.#notices.addError(outlook === "futures" ? "No futures" : "No uncertainty", messageOf(problem));
    this.changed();
  }
}
