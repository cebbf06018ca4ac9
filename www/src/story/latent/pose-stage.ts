// Shows single poses on the story's stage instead of the walk, and gives the stage back.
import type { Motion } from "../../engine/protocol";
import type { Fade } from "../../stage/stage-store";
import type { StoryBody } from "../../app/story-body";

export class PoseStage {
  readonly #body: StoryBody;
  #posed = false;

  constructor(body: StoryBody) {
    this.#body = body;
  }

  /** Shows a pose [nodes x 3], one part of it faintly. */
  show(positions: Float32Array, fade: Fade): void {
    const { stage, model } = this.#body;
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
    const { stage } = this.#body;
    if (!stage.content) return;
    this.#posed = true;
    stage.showModel({ ...stage.content, motion });
  }

  /** Shows the walk again. */
  end(): void {
    const { stage, model } = this.#body;
    stage.setFade(null);
    if (!this.#posed || !stage.content || !model.rollout) return;
    this.#posed = false;
    stage.showModel({ ...stage.content, motion: model.rollout.motion });
  }
}
