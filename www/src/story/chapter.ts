// What the frame of the story and a chapter know of each other. The frame owns the address, the card, the keys
// and the fades; a chapter owns the stage, its control and its measurement.
import type { TemplateResult } from "lit";
import type { Settings } from "../settings/settings";
import type { Observed } from "../ui/store";

/** The question of a card, with its answers by id. */
export interface Guess {
  readonly question: string;
  readonly choices: Readonly<Record<string, string>>;
}

export interface Chapter extends Observed {
  /** The content of the stage; it fills the stage's box. */
  stage(): TemplateResult;
  /** The question that the visitor has not answered yet; null: there is none. The frame shows a button for each choice. */
  guess(): Guess | null;
  /** The visitor has guessed; the chapter shows and measures the answer. */
  guessed(choice: string): void;
  /** The one control of the card, below its text; null when it would give the answer away. */
  control(): TemplateResult | null;
  /** Sentences about what was measured at this moment; null until it is measured. Screen readers read them at once. */
  reveal(): TemplateResult | null;
  /** The equation in MathML, to fold out; null: the chapter has none. */
  equation(): TemplateResult | null;
  /** The settings with which the Lab shows this state. */
  lab(): Partial<Settings>;
  /** What a link says of this state besides the chapter, the camera and the time. */
  link?(): Pick<Settings, "cut">;
  /** Shows the state of a link. */
  restore?(link: Pick<Settings, "cut">): void;
  /** The chapter comes on screen: its motion starts. */
  arrive(): void;
  /** The chapter leaves the screen: everything stops, and shared stores are as before. The chapter may arrive again. */
  leave(): void;
}
