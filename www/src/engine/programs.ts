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

let player: Promise<WebAssembly.Module> | null = null;

/** Loads the program that shows, once for all its workers, and again after a failed download. */
export function loadPlayer(): Promise<WebAssembly.Module> {
  player ??= compile(new URL("../../../crate/wasm/pkg/player/vcgpdm_bg.wasm", import.meta.url)).catch(
    (problem: unknown) => {
      player = null;
      throw problem;
    },
  );
  return player;
}

let whole: Promise<WebAssembly.Module> | null = null;

/** Loads the whole program on the first call, and again after a failed download. */
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

/** Loads the whole program when the page is idle, unless the browser is set to save data. */
export function loadWholeWhenIdle(): void {
  const { connection } = navigator as Navigator & { connection?: { saveData?: boolean } };
  if (connection?.saveData) return;
  whenIdle(() => void loadWhole().catch(() => {}));
}
