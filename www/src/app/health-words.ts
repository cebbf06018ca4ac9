// What the page says over a motion that is none any more.
import { troubleText } from "../couplings/measures-text";
import type { BodyReport } from "../engine/protocol";
import { sentence } from "../ui/format";

/** What of it can be seen on the stage. */
interface Seen {
  /** Seconds of motion. */
  seconds: number;
  parts: readonly { name: string }[];
  /** A coupling is not as learned. */
  altered: boolean;
}

/** One sentence; empty where there is nothing to say. */
export function healthWords(health: BodyReport["health"], { seconds, parts, altered }: Seen): string {
  const names = parts.map(({ name }) => name);
  const words = troubleText(health, names);
  // What is measured may be longer than what is shown.
  if (!words || (health.from ?? 0) >= seconds) return "";
  if (health.state === "leaves the training range") return sentence(words);
  return sentence(`${altered ? "With these couplings the model" : "The model"} ${words}`);
}
