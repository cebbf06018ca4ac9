// The notice for a motion that is not healthy: its pose stops changing, it visits few poses of its clips, or it
// leaves what the model has learned.
import { troubleText } from "../couplings/measures-text";
import type { BodyReport } from "../engine/protocol";
import { sentence } from "../ui/format";
import { lab, shownPart } from "../words/lab";

/** The motion on the stage. */
interface StageMotion {
  /** Seconds of motion. */
  seconds: number;
  parts: readonly { name: string }[];
  /** Whether a coupling is changed. */
  altered: boolean;
}

/** One sentence; empty for a healthy motion. */
export function healthWords(health: BodyReport["health"], { seconds, parts, altered }: StageMotion): string {
  const names = parts.map(({ name }) => shownPart(name));
  const words = troubleText(health, names);
  // The measured motion may be longer than the shown one.
  if (!words || (health.from ?? 0) >= seconds) return "";
  if (health.state === "leaves-training-range") return sentence(words);
  return sentence(lab().stage.health(words, altered));
}
