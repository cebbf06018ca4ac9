// A worker of the whole program. No DOM.
import init from "vcgpdm";
import { serve, start } from "./serve";
import { wholeCalls } from "./whole-calls";

serve({ start: (wasm: WebAssembly.Module) => start(init, wasm), ...wholeCalls });
