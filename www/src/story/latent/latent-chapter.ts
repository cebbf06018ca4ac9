// A chapter about the latent space of one part: a large drawing of its loop next to the walking figure.
import { html, nothing, type TemplateResult } from "lit";
import type { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import { attempt } from "./attempt";
import type { Handle, LatentScene } from "./latent-view";
import { PoseStage } from "./pose-stage";
import { type WalkLoop, walkLoop } from "./walk-loop";

export abstract class LatentChapter extends Store implements LatentScene {
  protected readonly words: WordsStore;
  protected readonly body: StoryBody;
  protected readonly pose: PoseStage;
  /** Null before the model has arrived. */
  protected loop: WalkLoop | null = null;
  /** Whether the chapter is on screen. */
  protected isHere = false;

  constructor(words: WordsStore, body: StoryBody) {
    super();
    this.words = words;
    this.body = body;
    this.pose = new PoseStage(body);
  }

  abstract get projection(): Projection | null;
  abstract get moves(): boolean;
  abstract get handles(): readonly Handle[];
  abstract paint(draw: CanvasRenderingContext2D, plane: Plane, size: { width: number; height: number }): void;

  /** The loop has arrived with the model. */
  protected abstract begin(): Promise<void>;

  /** Waits for the loop of a part. Ends each constructor: `begin` needs all fields. `around`: see `walkLoop`. */
  protected awaitLoop(part: number, around: number): void {
    const open = () => {
      if (this.loop) return;
      this.loop = walkLoop(this.body, part, around);
      if (this.loop) attempt(this.body, this.begin());
    };
    this.body.model.on(open);
    open();
  }

  /** The drawing, which has this label, and the figure. */
  protected pair(label: string, notes: unknown = nothing): TemplateResult {
    const { stage, playback } = this.body;
    return html`
      <div class="story-pair">
        <pg-latent-space .scene=${this} .label=${label}></pg-latent-space>
        <pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${this.words.now.chapters.arms.figure}></pg-stage>
        ${notes}
      </div>`;
  }

  arrive(): void {
    this.isHere = true;
    this.body.open();
  }

  leave(): void {
    this.isHere = false;
    this.pose.end();
  }
}
