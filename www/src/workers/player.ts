// The worker that shows. No DOM.
import init, { version } from "vcgpdm/player";
import type { Workbench } from "../engine/protocol";
import { playerCalls, samples } from "./player-calls";
import { serve, start } from "./serve";

serve({
  async start(wasm) {
    await start(init, wasm);
    return { version: version(), samples: samples() };
  },
  ...playerCalls,
} satisfies Workbench);
