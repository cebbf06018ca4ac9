import type { App } from "../../app/app";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { GaussianChapter } from "./gaussian-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new GaussianChapter(app.words);
}
