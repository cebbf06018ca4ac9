// Primitives of another file: added where they fit the library, or learned again under its pose maps.
import type { ClipsStore } from "../clips/clips-store";
import type { Addition, Imported, LibraryInfo, Misfit } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { percent } from "../figures/numbers";
import type { LibraryStore } from "./library-store";
import { ProgressStore } from "../training/progress-store";
import { primitivesWords } from "../words/primitives";
import { shownPart } from "../words/lab";

const MOST_ITERATIONS = 200;

/** Primitives that do not fit the library. */
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
  #text = "";

  constructor(whole: WholeWorkers, clips: Pick<ClipsStore, "all">, library: LibraryStore) {
    super();
    this.#whole = whole;
    this.#clips = clips;
    this.#library = library;
  }

  /** The primitives that could be learned again; null without an offer. */
  get offer(): Offer | null {
    return this.#offer;
  }

  /** A text about the last file; empty before the first. */
  get text(): string {
    return this.#text;
  }

  /** Opens a file as a library, or adds its primitives if it has not those of a whole body. */
  async openFile(text: string, title: string): Promise<void> {
    await this.#library.openFirst();
    if (await this.#library.isWhole(text)) await this.#library.open(text, title);
    else await this.add(text, title);
  }

  /** Adds the primitives of a file, or offers to learn them again. */
  async add(text: string, title: string): Promise<void> {
    if (this.busy) throw new Error(primitivesWords().imports.busy);
    this.#offer = null;
    this.#text = "";
    const before = this.#library.current?.info;
    const addition = await this.#library.add(text);
    if (isAdded(addition)) this.#text = addedText(addition, before);
    else this.#offer = { title, text, misfit: addition.misfit };
    this.changed();
  }

  /** Learns the offered primitives again, from a clip, or without one from the data of their file. */
  async relearn(key: string, seed: number): Promise<void> {
    const { current } = this.#library;
    const offer = this.#offer;
    if (!current || !offer?.misfit.canBeRelearned || this.busy) return;
    const clips = this.#clips.all
      .filter((clip) => clip.key === key)
      .map(({ loaded, source, first, end }) => ({ id: loaded.id, source, first, end }));
    const job = { library: current.text, other: offer.text, clips, maxIterations: MOST_ITERATIONS, seed };
    const found = await this.run((report, signal) =>
      this.#whole.pool.run((worker) => worker.importPrimitives(job, report, signal), signal),
    );
    if (!found) return;
    const before = this.#library.current?.info;
    // The library may have grown meanwhile: only new primitives are added.
    const addition = await this.#library.add(found.text);
    if (!isAdded(addition)) {
      this.#offer = { ...offer, misfit: addition.misfit };
    } else {
      this.#offer = null;
      this.#text = `${addedText(addition, before)} ${lostText(addition.info, found.lost)}`;
    }
    this.changed();
  }

  /** Declines the offer. */
  dismiss(): void {
    if (this.busy) return;
    this.#offer = null;
    this.#text = "";
    this.changed();
  }
}

/** "Added lower: walk." */
function addedText(
  { info, added }: { info: LibraryInfo; added: number },
  before: LibraryInfo | undefined,
): string {
  const fresh = info.primitives.slice(before?.primitives.length ?? 0);
  if (added === 0 || fresh.length === 0) return primitivesWords().imports.known;
  return primitivesWords().imports.added(
    fresh.map(({ part, name }) => `${shownPart(info.parts[part]?.name ?? "")}: ${name}`).join(", "),
  );
}

/** The share of the variance that the pose maps of this library cannot show. */
function lostText({ parts }: LibraryInfo, lost: readonly number[]): string {
  return primitivesWords().imports.lost(
    parts.map(({ name }, part) => [percent(lost[part] ?? 0), name] as const),
  );
}
