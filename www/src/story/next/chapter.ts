import type { App } from "../../app/app";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { NextChapter } from "./next-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new NextChapter(app.words, app.story);
}
