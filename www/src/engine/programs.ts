// The two wasm programs: one that shows, for the first visit, and the whole one, which trains and compares.
// No wasm import.
import { messageOf } from "../ui/format";
import { whenIdle } from "../ui/idle";

/** Compiles a program, once for all its workers. */
async function compile(place: URL): Promise<WebAssembly.Module> {
  const answer = await fetch(place);
  if (!answer.ok) throw new Error(`the host answered ${answer.status} for ${answer.url}`);
  // Not every host knows what a .wasm file is.
  const named = answer.headers.get("Content-Type")?.startsWith("application/wasm") ?? false;
  return named ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

export const loadPlayer = () =>
  compile(new URL("../../../crate/wasm/pkg/player/vcgpdm_bg.wasm", import.meta.url));

let whole: Promise<WebAssembly.Module> | null = null;

/** Loads the whole program at the first time, and again after a download that failed. */
export function loadWhole(): Promise<WebAssembly.Module> {
  whole ??= compile(new URL("../../../crate/wasm/pkg/web/vcgpdm_bg.wasm", import.meta.url)).catch(
    (problem: unknown) => {
      whole = null;
      const why = messageOf(problem);
      throw new Error(`the program for it could not be loaded (${why}). Try again when you are online.`);
    },
  );
  return whole;
}

/**
 * Loads the whole program when the page has nothing else to do; not where the visitor's connection is to be
 * spared.
 */
export function loadWholeWhenIdle(): void {
  const { connection } = navigator as Navigator & { connection?: { saveData?: boolean } };
  if (connection?.saveData) return;
  whenIdle(() => void loadWhole().catch(() => {}));
}
