// What a visitor changes of a model on the stage: of a TMP or DMP its tempo, and its pose or goal by a drag of the
// figure; of a MAP CGPDM its couplings.
import { CouplingsStore } from "../couplings/couplings-store";
import { Latest } from "../engine/latest";
import type { ByHand, Drag, MadeMotion } from "../engine/whole-protocol";
import { fromRoot } from "../scene/motion";
import type { Playback } from "../stage/playback";
import { Store } from "../ui/store";

export class HandlesStore extends Store {
  /** What a drag changes. */
  changes: Drag["changes"] = "pose";
  /** Where the drag began; null: no drag. */
  #grabbed: { frame: number; handles: ByHand; played: boolean } | null = null;
  readonly #rolls: Latest<[ByHand, Drag?], MadeMotion>;
  /** What was asked for, until its motion is there. */
  #asked: [ByHand, Drag?] | null = null;
  /** Those of a MAP CGPDM. */
  readonly couplings = new CouplingsStore(() => {
    this.#ask(this.couplings.altered ? { alpha: this.couplings.alpha } : {});
    this.changed();
  });

  /**
   * `roll`: the motion under these handles and a drag, which it adds to them. `isShown`: whether the motion is on
   * the stage.
   */
  constructor(
    private readonly playback: Playback,
    private made: MadeMotion,
    private readonly isShown: () => boolean,
    roll: (handles: ByHand, drag?: Drag) => Promise<MadeMotion>,
    show: (made: MadeMotion) => void,
    failed: (problem: unknown) => void,
  ) {
    super();
    this.couplings.learn(made.alpha);
    const take = (next: MadeMotion, request: [ByHand, Drag?]) => {
      this.made = next;
      if (request === this.#asked) this.#asked = null;
      if (this.isShown()) show(next);
      this.changed();
    };
    this.#rolls = new Latest(
      ([handles, drag]) => roll(handles, drag),
      take,
      (problem) => {
        this.#asked = null;
        failed(problem);
      },
    );
  }

  #ask(...asked: [ByHand, Drag?]): void {
    this.#asked = asked;
    this.#rolls.request(asked);
  }

  get kind() {
    return this.made.kind;
  }

  get parts() {
    return this.made.parts;
  }

  /** Whether limbs can be dragged. */
  get running(): boolean {
    return this.isShown() && this.couplings.learned.length === 0;
  }

  get tempo(): number {
    return this.made.handles.tempo ?? 1;
  }

  set tempo(tempo: number) {
    const [handles, drag] = this.#asked ?? [this.made.handles];
    this.#ask({ ...handles, tempo }, drag);
  }

  choose(changes: Drag["changes"]): void {
    this.changes = changes;
    this.changed();
  }

  /** The motion as learned. */
  reset(): void {
    if (this.couplings.altered) this.couplings.resetAll();
    else this.#ask({});
  }

  get isAsLearned(): boolean {
    const { goal, push } = this.made.handles;
    return this.tempo === 1 && !goal && !push && !this.couplings.altered;
  }

  /** Holds the figure in this frame, with a node at its place in the picture, shifted by metres. */
  reach(node: number, by: readonly [number, number, number]): void {
    const { playback } = this;
    this.#grabbed ??= {
      frame: Math.round(playback.frame),
      handles: this.#asked?.[0] ?? this.made.handles,
      played: playback.playing,
    };
    const { frame, handles } = this.#grabbed;
    if (playback.playing) playback.scrub(frame);
    const { pose } = playback;
    if (!pose) return;
    const place = playback.turnedBack(fromRoot(pose, node, by));
    this.#ask(handles, { frame, node, place, changes: this.changes });
  }

  /** Lets the figure go. */
  letGo(): void {
    if (this.#grabbed?.played) this.playback.play();
    this.#grabbed = null;
  }

  /** Lifts a hand: what a drag does, without a pointer. */
  lift(): void {
    const { pose } = this.playback;
    if (!pose) return;
    const away = (node: number) => Math.hypot(pose[3 * node]! - pose[0]!, pose[3 * node + 2]! - pose[2]!);
    const nodes = this.made.figure.nodes.map((_, node) => node);
    const high = nodes.filter((node) => pose[3 * node + 1]! > 0.7 * pose[1]!);
    this.reach(
      high.reduce((a, b) => (away(b) > away(a) ? b : a)),
      [0, 0.3, 0],
    );
    this.letGo();
  }
}
