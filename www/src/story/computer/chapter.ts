import type { App } from "../../app/app";
import type { Chapter } from "../chapter";
import { ComputerChapter } from "./computer-chapter";
import { fetchWalkers } from "./walkers";
import "./walkers-view";

export async function openChapter({ words }: App): Promise<Chapter> {
  return new ComputerChapter(words, await fetchWalkers());
}
