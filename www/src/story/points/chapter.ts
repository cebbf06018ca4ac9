import type { App } from "../../app/app";
import { wholeWorkers } from "../../engine/whole-workers";
import "../../stage/stage-view";
import { storyBody } from "../body";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { PointsChapter } from "./points-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new PointsChapter(app.words, storyBody(app), wholeWorkers());
}
