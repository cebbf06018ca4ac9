// The library that is looked at, and the combination of its primitives that walks.
import { changedFrom, CouplingsStore } from "../couplings/couplings-store";
import type { Addition, CouplingsFrom, Fitted, LibraryInfo, PartMotion } from "../engine/library-protocol";
import { Latest } from "../engine/latest";
import type { Couplings, Motion } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { Body } from "../scene/columns";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { combinationsOf, countOf, exampleOf, firstOf, isSame, recordedAs, titleOf } from "./combinations";
import { LibraryWorker } from "./library-worker";
import { WalkStore } from "./walk-store";

/** More combinations have no room in the gallery. */
const MOST_SHOWN = 36;
/** Milliseconds that couplings rest before it is looked what they do. */
const LOOK_AFTER = 300;
/** Frames of a small figure, which walks them again and again. */
const SMALL_FRAMES = 120;

/** A library, and where it comes from. */
export interface KnownLibrary {
  text: string;
  info: LibraryInfo;
  /** "the library that comes with this page", or the name of its file. */
  title: string;
  /** Whether it would be lost: it was learned or changed here, and not saved since. */
  unsaved: boolean;
}

/** A part that is on its way to another of its primitives. */
export interface Mix {
  other: number;
  /** 0 to 1 */
  share: number;
}

const isUnsaved = ({ unsaved }: KnownLibrary) => unsaved;

export class LibraryStore extends Store {
  readonly walk: WalkStore;
  /** Learned are the couplings that the primitives were learned with, or fitted. */
  readonly couplings = new CouplingsStore((change) => this.#walkUnder(change === "all"));
  readonly #held: LibraryWorker;
  readonly #notices: NoticesStore;
  readonly #fetchStartFile: () => Promise<string>;
  #known: KnownLibrary | null = null;
  /**
   * Those before, the last of which the one that is looked at has taken the place of: it, and all that would
   * be lost.
   */
  #earlier: readonly KnownLibrary[] = [];
  #opening: Promise<void> | null = null;
  #problem = "";
  /** The document of the library that comes with the page. */
  #first: string | null = null;
  #uses: readonly number[] = [];
  /** Whether the figure was given couplings since its primitives changed. */
  #touched = false;
  /** The couplings that were fitted last, and what to. */
  #fitted: (Fitted & { uses: readonly number[] }) | null = null;
  /** What the parts do under the couplings that were looked at last. */
  #moves: readonly PartMotion[] = [];
  #look: ReturnType<typeof setTimeout> | undefined;
  #tempos: readonly number[] = [];
  #mixes: readonly (Mix | null)[] = [];
  /** Of the small figures; another library has others. */
  #motions = new Map<string, Motion>();
  #body: Body | null = null;
  readonly #couplings: Latest<readonly number[], Couplings>;
  readonly #movesOf: Latest<{ uses: readonly number[]; alpha: Couplings }, PartMotion[]>;

  /** `fetchStartFile`: the document of the library that comes with the page. */
  constructor(whole: WholeWorkers, notices: NoticesStore, fetchStartFile: () => Promise<string>) {
    super();
    this.#held = new LibraryWorker(whole);
    this.walk = new WalkStore(this.#held, notices);
    this.#notices = notices;
    this.#fetchStartFile = fetchStartFile;
    this.#couplings = new Latest(
      (uses) => this.nearestTo(uses),
      (alpha, uses) => {
        if (!isSame(uses, this.#uses)) return;
        // The figure has them already.
        if (this.#touched) this.#takeNearest(alpha);
        else this.#showNearest(alpha);
      },
      (problem) => this.#notices.addError("These primitives could not be put together", messageOf(problem)),
    );
    this.#movesOf = new Latest(
      ({ uses, alpha }) => this.#held.ask((worker) => worker.combinationMoves([...uses], alpha)),
      (moves, { uses }) => {
        if (!isSame(uses, this.#uses)) return;
        this.#moves = moves;
        this.changed();
      },
      // A figure that cannot be rolled out says so itself.
      () => {},
    );
  }

  get known(): KnownLibrary | null {
    return this.#known;
  }

  /** What is kept of it for the next visit: nothing where it is the page's own, as it came. */
  get kept(): Pick<KnownLibrary, "text" | "title" | "unsaved"> | null {
    const known = this.#known;
    if (!known || (known.title === "" && known.text === this.#first)) return null;
    const { text, title, unsaved } = known;
    return { text, title, unsaved };
  }

  get before(): KnownLibrary | null {
    return this.#earlier.at(-1) ?? null;
  }

  /** All libraries of this visit that are on no disk. */
  get unsaved(): readonly KnownLibrary[] {
    return this.#known ? [...this.#earlier, this.#known].filter(isUnsaved) : [];
  }

  /** Why there is no library; empty when there is one, or soon will be. */
  get problem(): string {
    return this.#problem;
  }

  /** The primitive of each part. */
  get uses(): readonly number[] {
    return this.#uses;
  }

  /** The movement that was recorded with these primitives; null: never recorded. */
  get recorded(): string | null {
    return this.#known && recordedAs(this.#known.info, this.#uses);
  }

  get title(): string {
    return this.#known ? titleOf(this.#known.info, this.#uses) : "";
  }

  get tempos(): readonly number[] {
    return this.#tempos;
  }

  get mixes(): readonly (Mix | null)[] {
    return this.#mixes;
  }

  /** What each part does in the long run, and to whom it listens; empty where that is not known yet. */
  get moves(): readonly PartMotion[] {
    return this.#moves;
  }

  /** The combinations of the gallery. */
  get combinations(): number[][] {
    return this.#known ? combinationsOf(this.#known.info, MOST_SHOWN) : [];
  }

  /** How many combinations the gallery has no room for. */
  get notShown(): number {
    return this.#known ? Math.max(0, countOf(this.#known.info) - MOST_SHOWN) : 0;
  }

  /** The body of the library; null before there is one. */
  get body(): Body | null {
    return this.#body;
  }

  /** The first frames of a combination; null until they are there. */
  motionOf(uses: readonly number[]): Motion | null {
    return this.#motions.get(uses.join()) ?? null;
  }

  /** Opens the library that comes with the page, at the first time. */
  openFirst(): Promise<void> {
    if (this.#known) return Promise.resolve();
    this.#opening ??= this.#openFirst().finally(() => {
      this.#opening = null;
    });
    return this.#opening;
  }

  async #openFirst(): Promise<void> {
    this.#problem = "";
    this.changed();
    try {
      const text = await this.#fetchStartFile();
      this.#first = text;
      // The visitor's own may have come first.
      if (!this.#known) await this.open(text, "");
    } catch (problem) {
      this.#problem = messageOf(problem);
      this.changed();
    }
  }

  /**
   * Takes a library up from its document. The one before can be brought back, and so can all before it that
   * are not saved.
   */
  async open(text: string, title: string, unsaved = false): Promise<void> {
    const info = await this.#held.open(text);
    const before = this.#known ? [this.#known] : [];
    await this.#takeUp({ text, info, title, unsaved }, [...this.#earlier.filter(isUnsaved), ...before]);
  }

  /** Back to the library before this one, which comes round again if it is not saved. */
  async undo(): Promise<void> {
    const { before } = this;
    if (!before) return;
    await this.#held.open(before.text);
    const last = this.#known ? [this.#known].filter(isUnsaved) : [];
    await this.#takeUp(before, [...last, ...this.#earlier.slice(0, -1)]);
  }

  async #takeUp(library: KnownLibrary, earlier: readonly KnownLibrary[]): Promise<void> {
    this.#earlier = earlier;
    this.#known = library;
    this.#problem = "";
    this.#motions = new Map();
    const { figure, parts, joints } = library.info;
    this.#body = { figure, parts, joints: joints.map(({ name }) => name) };
    this.#mixes = library.info.parts.map(() => null);
    this.#tempos = library.info.parts.map(() => 1);
    this.#uses = firstOf(library.info, this.combinations);
    this.#showNearest(await this.nearestTo(this.#uses));
    await this.walk.start(library.info, this.#uses);
    this.changed();
    void this.#rollOutSmall(library.info);
  }

  /** Another of its primitives for one part; the others go on. */
  choose(part: number, primitive: number): void {
    if (this.#known?.info.primitives[primitive]?.part !== part) return;
    this.take(this.#uses.map((before, other) => (other === part ? primitive : before)));
  }

  /** Goes on with another combination, under the couplings that its primitives were learned with. */
  take(uses: readonly number[]): void {
    if (isSame(uses, this.#uses) && this.#mixes.every((mix) => mix === null)) return;
    this.#mixes.forEach((mix, part) => {
      if (mix) this.walk.change({ kind: "mix", part, other: mix.other, share: 0 });
    });
    // Primitives together with their couplings, so that it has to catch itself only once.
    uses.forEach((primitive, part) => {
      if (primitive !== this.#uses[part]) this.walk.change({ kind: "use", part, primitive });
    });
    this.walk.change({ kind: "nearest", uses }, true);
    this.#touched = false;
    this.#uses = uses;
    this.#mixes = uses.map(() => null);
    // After the figure, which shall not wait.
    queueMicrotask(() => this.#couplings.request(uses));
    this.changed();
  }

  /** They act from the next frame on. */
  takeCouplings(alpha: Couplings): void {
    this.couplings.takeAll(changedFrom(this.couplings.learned, alpha));
  }

  /** Couplings that were fitted for this combination: what the sliders go back to. */
  takeFitted(uses: readonly number[], fitted: Fitted): void {
    if (!isSame(uses, this.#uses)) return;
    this.#fitted = { ...fitted, uses };
    this.#takeNearest(fitted.alpha);
  }

  setTempo(part: number, tempo: number): void {
    this.#tempos = this.#tempos.map((before, other) => (other === part ? tempo : before));
    this.walk.change({ kind: "tempo", part, tempo });
    this.changed();
  }

  /** Moves a part so far, 0 to 1, to another of its primitives. */
  setMix(part: number, other: number, share: number): void {
    this.#mixes = this.#mixes.map((mix, index) => (index === part ? { other, share } : mix));
    this.walk.change({ kind: "mix", part, other, share });
    this.changed();
  }

  /** The couplings that the primitives of a combination were learned with. */
  nearestTo(uses: readonly number[]): Promise<Couplings> {
    return this.#held.ask((worker) => worker.nearestCouplings([...uses]));
  }

  /** The document of the combination as a model of its own. */
  combinationText(): Promise<string> {
    return this.#held.ask((worker) => worker.combinationText([...this.#uses], this.couplings.alpha));
  }

  /** Adds the combination, under these couplings, to the library as a movement of this name. */
  async keep(name: string): Promise<void> {
    const known = this.#known;
    if (!known) return;
    const { text, info } = await this.#held.add(name, this.#uses, this.couplings.alpha, this.#from);
    this.#known = { ...known, text, info, unsaved: true };
    this.changed();
  }

  /** The document of one primitive as a file of its own. */
  primitiveText(primitive: number): Promise<string> {
    return this.#held.ask((worker) => worker.primitivesText([primitive]));
  }

  /** Whether the document is a library that can walk, not some primitives that can only be added to one. */
  isWhole(text: string): Promise<boolean> {
    return this.#held.ask((worker) => worker.isWholeLibrary(text));
  }

  /** Adds the primitives of another file, where they fit; the figure goes on. */
  async add(text: string): Promise<Addition> {
    const addition = await this.#held.take(text);
    const known = this.#known;
    if (!("info" in addition) || !known) return addition;
    this.#known = {
      ...known,
      text: addition.text,
      info: addition.info,
      unsaved: known.unsaved || addition.added > 0,
    };
    this.changed();
    void this.#rollOutSmall(addition.info);
    return addition;
  }

  /** Where the couplings of now come from, as far as the page alone knows it. */
  get #from(): CouplingsFrom | null {
    const fitted = this.#fitted;
    const isFitted =
      fitted &&
      isSame(fitted.uses, this.#uses) &&
      JSON.stringify(fitted.alpha) === JSON.stringify(this.couplings.alpha);
    return isFitted ? fitted.from : null;
  }

  /** The document, which now is on the visitor's disk. */
  save(): string {
    if (!this.#known) return "";
    this.#known = { ...this.#known, unsaved: false };
    this.changed();
    return this.#known.text;
  }

  /** The figure goes on under the couplings now. */
  #walkUnder(leaps: boolean): void {
    this.#touched = true;
    this.walk.change({ kind: "couplings", alpha: this.couplings.alpha }, leaps);
    this.#couplingsChanged();
  }

  #couplingsChanged(): void {
    this.#moves = [];
    this.#movesOf.drop();
    this.#lookLater();
    this.changed();
  }

  /** Looks what the parts do once the couplings rest: a slider that is dragged shall not wait for it. */
  #lookLater(): void {
    clearTimeout(this.#look);
    this.#look = setTimeout(
      () => this.#movesOf.request({ uses: this.#uses, alpha: this.couplings.alpha }),
      LOOK_AFTER,
    );
  }

  #takeNearest(alpha: Couplings): void {
    this.couplings.learn(alpha);
    this.#walkUnder(true);
  }

  #showNearest(alpha: Couplings): void {
    this.couplings.learn(alpha);
    this.#couplingsChanged();
  }

  /** The motions of the small figures, one after the other. */
  async #rollOutSmall(info: LibraryInfo): Promise<void> {
    const motions = this.#motions;
    const examples = info.primitives.map((_, primitive) => exampleOf(info, primitive));
    for (const uses of [...examples, ...this.combinations]) {
      if (this.#motions !== motions) return;
      if (motions.has(uses.join())) continue;
      try {
        const motion = await this.#held.ask((worker) => worker.combinationMotion([...uses], SMALL_FRAMES));
        motions.set(uses.join(), motion);
      } catch (problem) {
        this.#notices.addError(`${titleOf(info, uses)} does not move`, messageOf(problem));
      }
      this.changedSoon();
    }
  }
}
