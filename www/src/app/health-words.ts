// What the page says of a rollout that is no motion any more.
import type { Health } from "../engine/protocol";

/** One sentence; empty where there is nothing to say. `altered`: a coupling is not as learned. */
export function healthWords(health: Health | null, parts: readonly { name: string }[], altered: boolean): string {
  if (!health) return "";
  const from = health.from === null || health.from < 0.05 ? "the start" : `${health.from.toFixed(1)} s on`;
  switch (health.state) {
    case "moves on":
    case "rests as recorded":
      return "";
    case "stands still":
      return `${altered ? "With these couplings the model" : "The model"} stands still from ${from}.`;
    case "leaves the training range": {
      const part = parts[health.part ?? -1]?.name ?? "a part";
      return `From ${from} ${part} is far from all that the model learned: what it does there means little.`;
    }
    case "not finite":
      return "The motion breaks down: its numbers grow without end.";
  }
}
