// The open library, and the combination of its primitives that walks.
import { changedFrom, CouplingsStore } from "../couplings/couplings-store";
import type { CouplingsFrom, Fitted, LibraryInfo, PartMotion } from "../engine/library-protocol";
import { Latest } from "../engine/latest";
import type { Couplings, LiveStep, Motion } from "../engine/protocol";
import { OpenDocument } from "../engine/open-document";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { LiveStore } from "../live/live-store";
import type { Body } from "../scene/columns";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { combinationsOf, countOf, exampleOf, firstOf, isSame, recordedAs, titleOf } from "./combinations";
import { primitivesWords } from "./view-words";
import { shownPart } from "../words/lab";

/** The largest number of combinations in the gallery. */
const MOST_SHOWN = 36;
/** Milliseconds after the last change of couplings before their effect is computed. */
const LOOK_AFTER = 300;
/** Frames of the loop of a small figure. */
const SMALL_FRAMES = 120;

/** A library, and its origin. */
export interface OpenLibrary {
  text: string;
  info: LibraryInfo;
  /** The name of its file; empty for the library of the page. */
  title: string;
  /** Whether it was learned or changed here, and not saved since. */
  unsaved: boolean;
}

type ChangedLibrary = Pick<OpenLibrary, "text" | "info">;

/** "Added lower: walk." */
function addedText({ parts }: LibraryInfo, fresh: LibraryInfo["primitives"]): string {
  const { known, added } = primitivesWords().imports;
  const name = ({ part, name }: (typeof fresh)[number]) => `${shownPart(parts[part]?.name ?? "")}: ${name}`;
  return fresh.length === 0 ? known : added(fresh.map(name).join(", "));
}

const isUnsaved = ({ unsaved }: OpenLibrary) => unsaved;

export class LibraryStore extends Store {
  readonly playback = new Playback();
  readonly stage = new StageStore(this.playback);
  /** The motion without an end of the combination. */
  readonly walk: LiveStore;
  /** Its learned values are those that the primitives were learned with. */
  readonly couplings = new CouplingsStore((change) => this.#walkUnder(change === "all"));
  readonly #document: OpenDocument<WholeCalls, LibraryInfo>;
  /** The document that the worker has open. */
  #text = "";
  #current: OpenLibrary | null = null;
  /** Libraries that can be brought back: the previous one as the last, and before it unsaved ones. */
  #earlier: readonly OpenLibrary[] = [];
  #opening: Promise<void> | null = null;
  /** The number of libraries that were opened. */
  #opened = 0;
  #problem = "";
  /** The document of the library that comes with the page. */
  #first: string | null = null;
  #uses: readonly number[] = [];
  /** Whether the couplings were changed since the last change of primitives. */
  #touched = false;
  /** The last fitted couplings, with their combination. */
  #fitted: (Fitted & { uses: readonly number[] }) | null = null;
  /** The motion of each part under the last computed couplings. */
  #moves: readonly PartMotion[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;
  #tempos: readonly number[] = [];
  #addedText = "";
  /** The motions of the small figures. */
  #motions = new Map<string, Motion>();
  #body: Body | null = null;
  readonly #couplings: Latest<readonly number[], Couplings>;
  readonly #partMotions: Latest<{ uses: readonly number[]; alpha: Couplings }, PartMotion[]>;

  /** `fetchStartFile`: the document of the library that comes with the page. */
  constructor(
    whole: WholeWorkers,
    private readonly notices: NoticesStore,
    private readonly fetchStartFile: () => Promise<string>,
  ) {
    super();
    this.#document = new OpenDocument(whole.library, (worker, text) => worker.openLibrary(text));
    this.walk = new LiveStore(this.#source(), this.stage, this.playback, notices);
    let { playing } = this.playback;
    this.playback.on(() => {
      if (playing === this.playback.playing) return;
      playing = !playing;
      this.changed();
    });
    this.#couplings = new Latest(
      (uses) => this.nearestTo(uses),
      (alpha, uses) => {
        if (!isSame(uses, this.#uses)) return;
        // The worker has given these couplings to the figure already.
        if (this.#touched) this.#takeNearest(alpha);
        else this.#showNearest(alpha);
      },
      (problem) => this.notices.addError(primitivesWords().notPutTogether, messageOf(problem)),
    );
    this.#partMotions = new Latest(
      ({ uses, alpha }) => this.#ask((worker) => worker.combinationMoves([...uses], alpha)),
      (moves, { uses }) => {
        if (!isSame(uses, this.#uses)) return;
        this.#moves = moves;
        this.changed();
      },
      // A failed rollout has a notice of its own.
      () => {},
    );
  }

  #source() {
    const library = this;
    return {
      get body() {
        return library.#current?.info ?? null;
      },
      get revision() {
        return library.#opened;
      },
      couplings: null,
      on: (listener: () => void) => this.on(listener),
      begin: () => this.#ask((worker) => worker.startWalk([...this.#uses])),
      advance: (step: LiveStep) => this.#ask((worker) => worker.advanceWalk(step)),
      end: () => {},
    };
  }

  #ask<Answer>(call: (worker: WholeCalls) => Promise<Answer>): Promise<Answer> {
    return this.#document.ask(this.#text, call);
  }

  async #open(text: string): Promise<LibraryInfo> {
    const info = await this.#document.open(text);
    this.#text = text;
    return info;
  }

  /** A call in which the worker changes the library. */
  async #change(call: (worker: WholeCalls) => Promise<ChangedLibrary>): Promise<ChangedLibrary> {
    const changed = await this.#ask(call);
    this.#document.replace(changed.text);
    this.#text = changed.text;
    return changed;
  }

  /** Changes with the open library. */
  get revision(): number {
    return this.#opened;
  }

  get current(): OpenLibrary | null {
    return this.#current;
  }

  /** The library for the next visit; null for the unchanged library of the page. */
  get stored(): Pick<OpenLibrary, "text" | "title" | "unsaved"> | null {
    const current = this.#current;
    if (!current || (current.title === "" && current.text === this.#first)) return null;
    const { text, title, unsaved } = current;
    return { text, title, unsaved };
  }

  get before(): OpenLibrary | null {
    return this.#earlier.at(-1) ?? null;
  }

  /** All unsaved libraries of this visit. */
  get unsaved(): readonly OpenLibrary[] {
    return this.#current ? [...this.#earlier, this.#current].filter(isUnsaved) : [];
  }

  /** The reason why no library is open; empty otherwise. */
  get problem(): string {
    return this.#problem;
  }

  /** The primitive of each part. */
  get uses(): readonly number[] {
    return this.#uses;
  }

  /** The recorded movement with these primitives; null without one. */
  get recorded(): string | null {
    return this.#current && recordedAs(this.#current.info, this.#uses);
  }

  get title(): string {
    return this.#current ? titleOf(this.#current.info, this.#uses) : "";
  }

  get tempos(): readonly number[] {
    return this.#tempos;
  }

  /** What the last file with primitives added; empty before the first. */
  get addedText(): string {
    return this.#addedText;
  }

  /** The lasting motion of each part, and the part that leads it; empty before it is computed. */
  get moves(): readonly PartMotion[] {
    return this.#moves;
  }

  /** The combinations of the gallery. */
  get combinations(): number[][] {
    return this.#current ? combinationsOf(this.#current.info, MOST_SHOWN) : [];
  }

  /** Number of combinations that the gallery does not show. */
  get notShown(): number {
    return this.#current ? Math.max(0, countOf(this.#current.info) - MOST_SHOWN) : 0;
  }

  /** The body of the library; null before there is one. */
  get body(): Body | null {
    return this.#body;
  }

  /** The first frames of a combination; null before they are computed. */
  motionOf(uses: readonly number[]): Motion | null {
    return this.#motions.get(uses.join()) ?? null;
  }

  /** Opens the library of the page, if no library is open. */
  openFirst(): Promise<void> {
    if (this.#current) return Promise.resolve();
    this.#opening ??= this.#openFirst().finally(() => {
      this.#opening = null;
    });
    return this.#opening;
  }

  async #openFirst(): Promise<void> {
    this.#problem = "";
    this.changed();
    try {
      const text = await this.fetchStartFile();
      this.#first = text;
      // The visitor may have opened another library meanwhile.
      if (!this.#current) await this.open(text, "");
    } catch (problem) {
      this.#problem = messageOf(problem);
      this.changed();
    }
  }

  /** Opens a library from its document. The previous library and all unsaved ones can be brought back. */
  async open(text: string, title: string, unsaved = false): Promise<void> {
    const info = await this.#open(text);
    const before = this.#current ? [this.#current] : [];
    await this.#takeUp({ text, info, title, unsaved }, [...this.#earlier.filter(isUnsaved), ...before]);
  }

  /** Brings the previous library back. An unsaved current library comes back with more calls. */
  async undo(): Promise<void> {
    const { before } = this;
    if (!before) return;
    await this.#open(before.text);
    const last = this.#current ? [this.#current].filter(isUnsaved) : [];
    await this.#takeUp(before, [...last, ...this.#earlier.slice(0, -1)]);
  }

  async #takeUp(library: OpenLibrary, earlier: readonly OpenLibrary[]): Promise<void> {
    this.#earlier = earlier;
    this.#current = library;
    this.#problem = "";
    this.#motions = new Map();
    const { figure, parts, joints } = library.info;
    this.#body = { figure, parts, joints: joints.map(({ name }) => name) };
    this.#addedText = "";
    this.#tempos = library.info.parts.map(() => 1);
    this.#uses = firstOf(library.info, this.combinations);
    this.#opened += 1;
    this.#showNearest(await this.nearestTo(this.#uses));
    await this.#show(library.info);
    this.changed();
    void this.#rollOutSmall(library.info);
  }

  /** Shows the combination, which walks on if the figure before did. */
  async #show({ figure, joints, parts }: LibraryInfo): Promise<void> {
    const uses = this.#uses;
    const motion = await this.#ask((worker) => worker.combinationMotion([...uses], SMALL_FRAMES));
    this.#motions.set(uses.join(), motion);
    const { playing } = this.playback;
    this.walk.stop();
    this.stage.showModel({ kind: "model", figure, parts, motion, joints: joints.map(({ name }) => name) });
    await this.walk.start();
    if (!playing && this.playback.playing) this.playback.togglePlay();
  }

  /** Chooses another primitive for one part. */
  choose(part: number, primitive: number): void {
    if (this.#current?.info.primitives[primitive]?.part !== part) return;
    this.take(this.#uses.map((before, other) => (other === part ? primitive : before)));
  }

  /** Continues with another combination, under the couplings that its primitives were learned with. */
  take(uses: readonly number[]): void {
    if (isSame(uses, this.#uses)) return;
    // Primitives and couplings change in the same frame, so that there is one transition.
    uses.forEach((primitive, part) => {
      if (primitive !== this.#uses[part]) this.walk.change({ kind: "use", part, primitive });
    });
    this.walk.change({ kind: "nearest", uses }, true);
    this.#touched = false;
    this.#uses = uses;
    // The figure must not wait for this request.
    queueMicrotask(() => this.#couplings.request(uses));
    this.changed();
  }

  /** Sets all couplings from the next frame on. */
  takeCouplings(alpha: Couplings): void {
    this.couplings.takeAll(changedFrom(this.couplings.learned, alpha));
  }

  /** Takes fitted couplings of this combination. A reset brings those of its primitives back. */
  takeFitted(uses: readonly number[], fitted: Fitted): void {
    if (!isSame(uses, this.#uses)) return;
    this.#fitted = { ...fitted, uses };
    this.takeCouplings(fitted.alpha);
  }

  setTempo(part: number, tempo: number): void {
    this.#tempos = this.#tempos.map((before, other) => (other === part ? tempo : before));
    this.walk.change({ kind: "tempo", part, tempo });
    this.changed();
  }

  /** The couplings that the primitives of a combination were learned with. */
  nearestTo(uses: readonly number[]): Promise<Couplings> {
    return this.#ask((worker) => worker.nearestCouplings([...uses]));
  }

  /** The document of the combination as a model. */
  combinationText(): Promise<string> {
    return this.#ask((worker) => worker.combinationText([...this.#uses], this.couplings.alpha));
  }

  /** Adds the combination with its couplings to the library, as a movement of this name. */
  async keep(name: string): Promise<void> {
    const current = this.#current;
    if (!current) return;
    const { text, info } = await this.#change((worker) =>
      worker.addCombination(name, [...this.#uses], this.couplings.alpha, this.#from),
    );
    this.#current = { ...current, text, info, unsaved: true };
    this.changed();
  }

  /** The document of one primitive. */
  primitiveText(primitive: number): Promise<string> {
    return this.#ask((worker) => worker.primitivesText([primitive]));
  }

  /** Opens a file as a library, or adds its primitives if it has not those of a whole body. */
  async openFile(text: string, title: string): Promise<void> {
    await this.openFirst();
    if (await this.#ask((worker) => worker.isWholeLibrary(text))) await this.open(text, title);
    else await this.add(text);
  }

  /** Adds the primitives of another file. Throws the reason if they do not fit. */
  async add(text: string): Promise<void> {
    this.#addedText = "";
    const { text: added, info } = await this.#change((worker) => worker.addPrimitives(text));
    const current = this.#current;
    if (!current) return;
    const fresh = info.primitives.slice(current.info.primitives.length);
    this.#addedText = addedText(info, fresh);
    const unsaved = current.unsaved || fresh.length > 0;
    this.#current = { ...current, text: added, info, unsaved };
    this.changed();
    void this.#rollOutSmall(info);
  }

  /** Whether the combination now can be made again from a saved library: its couplings come with the library. */
  get isCombinationSaved(): boolean {
    return this.#current?.unsaved === false && !this.couplings.altered;
  }

  /** The origin of the couplings now, if they were fitted. */
  get #from(): CouplingsFrom | null {
    const fitted = this.#fitted;
    const isFitted = fitted && isSame(fitted.uses, this.#uses) && this.couplings.isAt(fitted.alpha);
    return isFitted ? fitted.from : null;
  }

  /** The document, marked as saved. */
  save(): string {
    if (!this.#current) return "";
    this.#current = { ...this.#current, unsaved: false };
    this.changed();
    return this.#current.text;
  }

  /** The figure continues under the couplings now. */
  #walkUnder(leaps: boolean): void {
    this.#touched = true;
    this.walk.change({ kind: "couplings", alpha: this.couplings.alpha, reading: "as-learned" }, leaps);
    this.#couplingsChanged();
  }

  #couplingsChanged(): void {
    this.#moves = [];
    this.#partMotions.drop();
    this.#measureSoon();
    this.changed();
  }

  /** Computes the motion of the parts after a pause, so that a dragged slider does not wait for it. */
  #measureSoon(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(
      () => this.#partMotions.request({ uses: this.#uses, alpha: this.couplings.alpha }),
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

  /** Computes the motions of the small figures, one after the other. */
  async #rollOutSmall(info: LibraryInfo): Promise<void> {
    const motions = this.#motions;
    const examples = info.primitives.map((_, primitive) => exampleOf(info, primitive));
    for (const uses of [...examples, ...this.combinations]) {
      if (this.#motions !== motions) return;
      if (motions.has(uses.join())) continue;
      try {
        const motion = await this.#ask((worker) => worker.combinationMotion([...uses], SMALL_FRAMES));
        motions.set(uses.join(), motion);
      } catch (problem) {
        this.notices.addError(primitivesWords().doesNotMove(titleOf(info, uses)), messageOf(problem));
      }
      this.changedSoon();
    }
  }
}
