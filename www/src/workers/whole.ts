// A worker of the whole program. No DOM.
import init from "vcgpdm";
import type { WholeWorker } from "../engine/whole-protocol";
import { serve, start } from "./serve";
import { wholeCalls } from "./whole-calls";

serve({ start: (wasm) => start(init, wasm), ...wholeCalls } satisfies WholeWorker);
