// A chapter about the latent space of one part: a large drawing of its loop next to the walking figure.
import { html, nothing, type TemplateResult } from "lit";
import type { Plane } from "../../latents/plane";
import { type Projection, principalAxes } from "../../latents/projection";
import type { ChapterName } from "../../settings/chapters";
import { GuessedChapter } from "../guessed-chapter";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Handle, LatentScene } from "./latent-view";
import type { Motion } from "../../engine/protocol";
import type { Fade } from "../../stage/stage-store";
import { type Lap, lapOf, projectPath } from "./drawing";
import { messageOf } from "../../ui/format";

/** Waits for work of a chapter; the frame shows the reason when it fails. */
export function attempt(body: StoryBody, work: Promise<unknown>): void {
  work.catch((problem: unknown) => body.notices.addError(messageOf(problem), ""));
}

interface WalkLoop {
  lap: Lap;
  /** The plane of the two widest directions of the loop. */
  projection: Projection;
  /** The lap on the axes of the plot [frames x 3]. */
  seen: Float64Array;
}

/** The loop of a part of the body; `around`: the plot shows this many times its width. Null before the model. */
function walkLoop({ model: { model, learned } }: StoryBody, part: number, around: number): WalkLoop | null {
  const path = learned?.latents[part];
  const dimensions = model?.info.parts[part]?.latent;
  if (!path || !dimensions) return null;
  const lap = lapOf(path, dimensions);
  const { flat, ...axes } = principalAxes(lap.path, dimensions);
  const [right, up] = flat;
  const projection: Projection = { ...axes, flat: [around * right, around * up] };
  return { lap, projection, seen: projectPath(projection, lap.path) };
}

class PoseStage {
  #posed = false;

  constructor(private readonly body: StoryBody) {}

  /** Shows a pose [nodes x 3], one part of it faintly. */
  show(positions: Float32Array, fade: Fade): void {
    const { stage, model } = this.body;
    const { content } = stage;
    const motion = model.rollout?.motion;
    if (!content || !motion) return;
    this.#posed = true;
    const { nodes, frameTime } = motion;
    stage.showModel({ ...content, motion: { positions, frames: 1, nodes, frameTime } });
    stage.setFade(fade);
  }

  /** Plays another motion of the same body. */
  play(motion: Motion): void {
    const { stage } = this.body;
    if (!stage.content) return;
    this.#posed = true;
    stage.showModel({ ...stage.content, motion });
  }

  /** Shows the walk again. */
  end(): void {
    const { stage, model } = this.body;
    stage.setFade(null);
    if (!this.#posed || !stage.content || !model.rollout) return;
    this.#posed = false;
    stage.showModel({ ...stage.content, motion: model.rollout.motion });
  }
}

export abstract class LatentChapter<Name extends ChapterName>
  extends GuessedChapter<Name>
  implements LatentScene
{
  protected readonly pose: PoseStage;
  /** Null before the model has arrived. */
  protected loop: WalkLoop | null = null;
  /** Whether the chapter is on screen. */
  protected isHere = false;

  constructor(
    words: WordsStore,
    name: Name,
    protected readonly body: StoryBody,
  ) {
    super(words, name);
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
        <pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${this.allWords.now.chapters.arms.figure}></pg-stage>
        ${notes}
      </div>`;
  }

  override arrive(): void {
    this.isHere = true;
    this.body.open();
  }

  override leave(): void {
    this.isHere = false;
    this.pose.end();
    super.leave();
  }
}
