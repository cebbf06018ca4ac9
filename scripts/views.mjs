// The views of the page: the folders of www/src that have a file entry.ts.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const sources = fileURLToPath(new URL("../www/src/", import.meta.url));

/** `name`: in the address and in the folder of the built files; `budget`: the most gzipped bytes. */
export const views = readdirSync(sources)
  .filter((folder) => existsSync(`${sources}${folder}/entry.ts`))
  .map((folder) => {
    const text = readFileSync(`${sources}${folder}/entry.ts`, "utf8");
    const [, name, budget] = /defineView\(\{\s*name: "([a-z]+)",\s*budget: ([\d_]+),/.exec(text) ?? [];
    if (!name || !budget)
      throw new Error(`www/src/${folder}/entry.ts: expected "defineView({", then a name and a budget`);
    return { folder, name, budget: Number(budget.replaceAll("_", "")) };
  });
