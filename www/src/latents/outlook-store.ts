// The outlook: sampled futures of the rollout on the stage, Gaussian moments of its latents, and pictures of
// how sure the model is.
import { ModelDocument } from "../couplings/model-document";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { RolloutRequest, RolloutResult } from "../engine/protocol";
import type { PartMoments, PlanePicture } from "../engine/whole-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { StageStore } from "../stage/stage-store";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { sameTimes } from "../couplings/weights";
import { PlanePictures } from "./plane-pictures";
import { lab } from "../words/lab";

export const FUTURES = 5;

/** Motions drawn at random, the band of moment matching, or the picture of how sure the model is. */
export type Outlook = "futures" | "uncertainty" | "certainty";

/** The moments of a rollout. */
interface Moments {
  revision: number;
  request: RolloutRequest;
  parts: PartMoments[];
}

export class OutlookStore extends Store {
  readonly #document: ModelDocument;
  readonly #pictures: PlanePictures;
  readonly #shown = new Set<Outlook>();
  #seed = 1;
  #futures: RolloutResult[] = [];
  #moments: Moments | null = null;
  /** The last rollout whose outlook was asked for. */
  #asked: RolloutResult | null = null;
  readonly #futuresAsked: Latest<{ rollout: RolloutResult; seed: number }, RolloutResult[]>;
  readonly #momentsAsked: Latest<RolloutResult, Moments>;

  constructor(
    engine: EngineStore,
    private readonly model: ModelStore,
    private readonly stage: StageStore,
    private readonly notices: NoticesStore,
    workers: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#document = new ModelDocument(engine, workers);
    this.#pictures = new PlanePictures(
      async ({ rollout: { revision, request }, part, picture }) =>
        this.#document.ask(revision, (worker) => worker.paintPlane(request, part, picture)),
      () => this.changed(),
      (problem) => this.#fail("certainty", problem),
    );
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

  /** The seed of the first future; the other futures have the next seeds. */
  get seed(): number {
    return this.#seed;
  }

  get futures(): readonly RolloutResult[] {
    return this.#futures;
  }

  /** The moments of each part; null before they have arrived. */
  get moments(): readonly PartMoments[] | null {
    return this.#moments?.parts ?? null;
  }

  /** The picture behind the plot of a part; null where it is not shown or has not arrived. */
  pictureOf(part: number, picture: PlanePicture): ImageBitmap | null {
    const { rollout } = this.model;
    return rollout && this.isShown("certainty") ? this.#pictures.pictureOf({ rollout, part, picture }) : null;
  }

  show(outlook: Outlook, shown: boolean): void {
    if (shown) this.#shown.add(outlook);
    else this.#shown.delete(outlook);
    this.#ask();
    this.changed();
  }

  /** Draws futures of the next seeds. */
  drawOthers(): void {
    this.#seed += FUTURES;
    this.#ask();
    this.changed();
  }

  /** Asks for the outlook that is shown, and drops futures and moments of another rollout. */
  #ask(): void {
    const { rollout } = this.model;
    this.#asked = rollout;
    if (!this.isShown("certainty")) this.#pictures.clear();
    const fits = (found: { revision: number; request: RolloutRequest } | null | undefined) =>
      rollout && found && found.revision === rollout.revision && sameTimes(found.request, rollout.request);
    if (!rollout || !this.isShown("futures") || (this.#futures.length > 0 && !fits(this.#futures[0])))
      this.#takeFutures([]);
    if (!rollout || !this.isShown("uncertainty") || !fits(this.#moments)) this.#takeMoments(null);
    if (rollout && this.isShown("futures")) this.#futuresAsked.request({ rollout, seed: this.#seed });
    else this.#futuresAsked.drop();
    if (rollout && this.isShown("uncertainty")) this.#momentsAsked.request(rollout);
    else this.#momentsAsked.drop();
  }

  async #match({ revision, request }: RolloutResult): Promise<Moments> {
    const parts = await this.#document.ask(revision, (worker) => worker.moments(request));
    return { revision, request, parts };
  }

  #takeFutures(futures: RolloutResult[]): void {
    if (futures.length === 0 && this.#futures.length === 0) return;
    // The worker may have opened another model whose answer has not arrived.
    const current = futures[0]?.revision === this.model.model?.revision;
    this.#futures = current ? futures : [];
    this.stage.setFutures(this.#futures.map(({ motion }) => motion));
    this.changed();
  }

  #takeMoments(moments: Moments | null): void {
    if (moments === this.#moments) return;
    this.#moments = moments && moments.revision === this.model.model?.revision ? moments : null;
    this.changed();
  }

  #fail(outlook: Outlook, problem: unknown): void {
    this.#shown.delete(outlook);
    this.#ask();
    this.notices.addError(lab().loops.none[outlook], messageOf(problem));
    this.changed();
  }
}
