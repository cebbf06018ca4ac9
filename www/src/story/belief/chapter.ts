import type { App } from "../../app/app";
import type { Chapter } from "../chapter";
import { BeliefChapter } from "./belief-chapter";
import "./belief.css";
import "./belief-view";

export async function openChapter(app: App): Promise<Chapter> {
  return new BeliefChapter(app.words, app.workers);
}
