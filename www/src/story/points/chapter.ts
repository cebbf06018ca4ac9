import type { App } from "../../app/app";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { PointsChapter } from "./points-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new PointsChapter(app.words, app.story, app.workers);
}
