// Primitives of another file: added where they fit the library, or learned again under its pose maps.
import type { ClipsStore } from "../clips/clips-store";
import type { Addition, Imported, LibraryInfo, Misfit } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { percent } from "../figures/numbers";
import type { LibraryStore } from "./library-store";
import { ProgressStore } from "../training/progress-store";

const MOST_ITERATIONS = 200;

/** Primitives that do not fit as they are. */
export interface Offer {
  /** The name of their file. */
  title: string;
  text: string;
  misfit: Misfit;
}

const isAdded = (addition: Addition): addition is Extract<Addition, { added: number }> => "added" in addition;

export class ImportStore extends ProgressStore<Imported> {
  readonly #whole: WholeWorkers;
  readonly #clips: Pick<ClipsStore, "all">;
  readonly #library: LibraryStore;
  #offer: Offer | null = null;
  #words = "";

  constructor(whole: WholeWorkers, clips: Pick<ClipsStore, "all">, library: LibraryStore) {
    super();
    this.#whole = whole;
    this.#clips = clips;
    this.#library = library;
  }

  /** What could be learned again; null: nothing. */
  get offer(): Offer | null {
    return this.#offer;
  }

  /** What became of the last file; empty before. */
  get words(): string {
    return this.#words;
  }

  /**
   * Opens a file: as the library that is looked at, or, where it holds no whole body, as primitives to be
   * added.
   */
  async openFile(text: string, title: string): Promise<void> {
    await this.#library.openFirst();
    if (await this.#library.isWhole(text)) await this.#library.open(text, title);
    else await this.add(text, title);
  }

  /** Adds the primitives of a file, or offers to learn them again. */
  async add(text: string, title: string): Promise<void> {
    if (this.busy) throw new Error("Primitives are being learned again: wait for them, or cancel.");
    this.#offer = null;
    this.#words = "";
    const before = this.#library.known?.info;
    const addition = await this.#library.add(text);
    if (isAdded(addition)) this.#words = addedWords(addition, before);
    else this.#offer = { title, text, misfit: addition.misfit };
    this.changed();
  }

  /**
   * Learns the offered primitives again: from the clip of this key, or, without one, from what their file
   * keeps.
   */
  async relearn(key: string, seed: number): Promise<void> {
    const { known } = this.#library;
    const offer = this.#offer;
    if (!known || !offer?.misfit.canBeRelearned || this.busy) return;
    const clips = this.#clips.all
      .filter((clip) => clip.key === key)
      .map(({ loaded, source, first, end }) => ({ id: loaded.id, source, first, end }));
    const job = { library: known.text, other: offer.text, clips, maxIterations: MOST_ITERATIONS, seed };
    const found = await this.run((report, signal) =>
      this.#whole.pool.run((worker) => worker.importPrimitives(job, report, signal), signal),
    );
    if (!found) return;
    const before = this.#library.known?.info;
    // The library may have grown meanwhile: of what was learned only what is new comes in.
    const addition = await this.#library.add(found.text);
    if (!isAdded(addition)) {
      this.#offer = { ...offer, misfit: addition.misfit };
    } else {
      this.#offer = null;
      this.#words = `${addedWords(addition, before)} ${lostWords(addition.info, found.lost)}`;
    }
    this.changed();
  }

  /** The offer is not taken. */
  dismiss(): void {
    if (this.busy) return;
    this.#offer = null;
    this.#words = "";
    this.changed();
  }
}

/** "Added lower: walk." */
function addedWords(
  { info, added }: { info: LibraryInfo; added: number },
  before: LibraryInfo | undefined,
): string {
  const fresh = info.primitives.slice(before?.primitives.length ?? 0);
  if (added === 0 || fresh.length === 0) return "These primitives are in the library already.";
  return `Added ${fresh.map(({ part, name }) => `${info.parts[part]?.name}: ${name}`).join(", ")}.`;
}

/** What the pose maps here cannot show. */
function lostWords({ parts }: LibraryInfo, lost: readonly number[]): string {
  const each = parts.map(({ name }, part) => `${percent(lost[part] ?? 0)} of ${name}`);
  return `The pose maps of this library do not show ${each.join(" and ")}.`;
}
