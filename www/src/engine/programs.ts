// The two wasm programs: the player, for the first visit, and the whole program, which also trains and
// compares. No wasm import.
import { messageOf } from "../ui/format";
import { whenIdle } from "../ui/browser";

/** Compiles a program, once for all its workers. */
async function compile(place: URL): Promise<WebAssembly.Module> {
  const answer = await fetch(place);
  if (!answer.ok) throw new Error(`the host answered ${answer.status} for ${answer.url}`);
  // Some hosts send .wasm files with another type.
  const named = answer.headers.get("Content-Type")?.startsWith("application/wasm") ?? false;
  return named ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** Loads a program once for all its workers, and again after a failed download. */
function loader(place: URL, failed: (problem: unknown) => unknown) {
  let program: Promise<WebAssembly.Module> | null = null;
  return () => {
    program ??= compile(place).catch((problem: unknown) => {
      program = null;
      throw failed(problem);
    });
    return program;
  };
}

/** Loads the program that shows. */
export const loadPlayer = loader(
  new URL("../../../crate/wasm/pkg/player/vcgpdm_bg.wasm", import.meta.url),
  (problem) => problem,
);

export const loadWhole = loader(
  new URL("../../../crate/wasm/pkg/web/vcgpdm_bg.wasm", import.meta.url),
  (problem) =>
    new Error(
      `the program for it could not be loaded (${messageOf(problem)}). Try again when you are online.`,
    ),
);

/** Loads the whole program when the page is idle, unless the browser is set to save data. */
export function loadWholeWhenIdle(): void {
  const { connection } = navigator as Navigator & { connection?: { saveData?: boolean } };
  if (connection?.saveData) return;
  whenIdle(() => void loadWhole().catch(() => {}));
}
