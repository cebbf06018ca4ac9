// The moment that a link carries: from where the camera looks, and the time of the motion.
import { distanceTo } from "../scene/motion";
import type { Motion } from "../engine/protocol";
import type { Settings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "./playback";
import type { StageStore } from "./stage-store";

export type Moment = Pick<Settings, "camera" | "time">;

/**
 * The moment on a stage. `motion`: the motion that the link shows; the pose of a live motion is found in it.
 */
export function momentOf(stage: StageStore, playback: Playback, motion: Motion | null): Moment {
  const camera = stage.camera() ?? [];
  const { content } = stage;
  const { pose } = playback;
  if (!content || !pose || !motion || content.motion === motion) return { camera, time: playback.seconds };
  if (content.motion.nodes !== motion.nodes) return { camera, time: 0 };
  return { camera, time: nearestFrame(motion, pose) * motion.frameTime };
}

/** The frame whose pose is most like this one, wherever the body is and whatever its heading. */
export function nearestFrame(motion: Motion, pose: Float32Array): number {
  let [best, least] = [0, Infinity];
  for (let frame = 0; frame < motion.frames; frame++) {
    const away = distanceTo(motion, frame, pose);
    if (away < least) [best, least] = [frame, away];
  }
  return best;
}

/** Takes the moment of a link, which the address then has no more. */
export function takeMoment(settings: SettingsStore, stage: StageStore, playback: Playback): void {
  const { camera, time } = settings.values;
  if (!stage.content || (camera.length === 0 && time === 0)) return;
  settings.change({ camera: [], time: 0 });
  if (camera.length > 0) stage.lookFrom(camera);
  if (time > 0) playback.seekSeconds(time);
}
