import type { App } from "../../app/app";
import "../../stage/stage-view";
import { storyBody } from "../body";
import "../latent/latent.css";
import type { Chapter } from "../chapter";
import { EndChapter } from "./end-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new EndChapter(app.words, storyBody(app));
}
