import type { App } from "../../app/app";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { LoopChapter } from "./loop-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new LoopChapter(app.words, app.story);
}
