// Recordings that move parts of the live motion. The latents of the part come from the model's filter, once.
import type { Recording } from "../completing/recordings";
import { Latest } from "../engine/latest";
import type { CompletedClip } from "../engine/whole-protocol";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { completingWords } from "../words/sections";
import type { LiveStore } from "./live-store";

/** The recordings of a body, and what a model infers of them. */
export interface BodyRecordings {
  readonly all: readonly Recording[];
  /** Changes with the model. */
  readonly revision: number;
  on(listener: () => void): () => void;
  /** The model observes one part of a recording. */
  infer(part: number, recording: Recording): Promise<CompletedClip>;
}

interface Asked {
  revision: number;
  part: number;
  recording: Recording;
}

export class RecordedParts extends Store {
  /** The requests of each part: of one part only the newest counts. */
  readonly #asked = new Map<number, Latest<Asked, CompletedClip>>();
  /** The key of the recording that each part waits for. */
  readonly #waiting = new Map<number, string>();

  constructor(
    private readonly recordings: BodyRecordings,
    private readonly live: LiveStore,
    private readonly notices: NoticesStore,
  ) {
    super();
    recordings.on(() => this.changed());
  }

  /** The requests of a part. */
  #requests(part: number): Latest<Asked, CompletedClip> {
    const known = this.#asked.get(part);
    if (known) return known;
    const requests = new Latest<Asked, CompletedClip>(
      ({ recording }) => this.recordings.infer(part, recording),
      (completed, asked) => this.#take(completed, asked),
      (problem) => {
        this.#waiting.delete(part);
        this.changed();
        this.notices.addError(completingWords().failed, messageOf(problem));
      },
    );
    this.#asked.set(part, requests);
    return requests;
  }

  /** The recordings to choose from; the model needs another part, which it infers. */
  get all(): readonly Recording[] {
    return (this.live.body?.parts.length ?? 0) > 1 ? this.recordings.all : [];
  }

  /** The recording that a part waits for or has. */
  keyOf(part: number): string | null {
    const mover = this.live.moverOf(part);
    return this.#waiting.get(part) ?? (mover?.kind === "record" ? mover.key : null);
  }

  /** Lets a recording move a part as soon as its latents are there; null: not any more. */
  choose(part: number, key: string | null): void {
    const { revision } = this.recordings;
    const recording = this.all.find((recording) => recording.key === key);
    this.#waiting.delete(part);
    if (recording) {
      this.#waiting.set(part, recording.key);
      this.#requests(part).request({ revision, part, recording });
    }
    this.changed();
  }

  #take({ recorded, latents }: CompletedClip, { revision, part, recording }: Asked): void {
    const { key, title } = recording;
    if (this.#waiting.get(part) !== key) return;
    this.#waiting.delete(part);
    if (revision === this.recordings.revision)
      this.live.record(part, { key, title, latents, motion: recorded });
    this.changed();
  }
}
