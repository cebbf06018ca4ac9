import type { App } from "../../app/app";
import "../../stage/stage-view";
import type { Chapter } from "../chapter";
import "../latent/latent-view";
import { ProductChapter } from "./product-chapter";

export async function openChapter(app: App): Promise<Chapter> {
  return new ProductChapter(app.words, app.story);
}
