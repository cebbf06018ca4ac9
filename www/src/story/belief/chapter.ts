import type { App } from "../../app/app";
import { wholeWorkers } from "../../engine/whole-workers";
import type { Chapter } from "../chapter";
import { BeliefChapter } from "./belief-chapter";
import "./belief.css";
import "./belief-view";

export async function openChapter(app: App): Promise<Chapter> {
  return new BeliefChapter(app.words, wholeWorkers());
}
