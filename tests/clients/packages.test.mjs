// The npm package in other people's tools, installed as usual: bundlers, runtimes, compilers.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, describe } from "node:test";
import { at } from "../../scripts/run.mjs";
import { clear, client, run, titleIn, titleOf, tool, withServer } from "./packages.mjs";

after(clear);

const DONE = /^done: 252 frames/;
const html = (/** @type {string} */ script) =>
  `<!doctype html>\n<meta charset="utf-8">\n<title>waiting</title>\n<script type="module" src="${script}"></script>\n`;
/** A program that writes the number of frames of a sample into the title. */
const app = (/** @type {string} */ from = "vcgpdm") => `import init, { Clip } from "${from}";
await init();
document.title = "done: " + Clip.sample("walk-1").info().frames + " frames";
`;
/** The worker of the README, with settings for a short training. */
const readme = readFileSync(at("crate/wasm/README.md"), "utf8");
const worker = readme.match(/```js\n(\/\/ worker\.js[\s\S]*?)```/)?.[1] ?? "";
const settings =
  "{ latent: 1, dynamicsIps: 3, poseIps: 3, order: 1, framesPerSecond: 15, seed: 1, maxIterations: 2 }";
const withWorker = `const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
worker.onmessage = ({ data }) => { document.title = "done: " + JSON.parse(data).format; };
worker.postMessage(${settings});
`;

/** Trains in the worker of the package, and writes how many workers were started. */
const withTrain = `import init, { Clip, train } from "vcgpdm";
let started = 0;
const Plain = globalThis.Worker;
globalThis.Worker = class extends Plain {
  constructor(...given) {
    super(...given);
    started += 1;
  }
};
await init();
let reports = 0;
const model = await train(Clip.sample("walk-1").cut(0, 60), {
  ...${settings},
  parts: "lower,upper",
  onProgress: () => { reports += 1; },
});
const { kind, parts } = model.info();
document.title = "done: " + [kind, parts.length, started, reports > 0, model.rollout({ frames: 9 }).frames].join(" ");
`;
const TRAINED = "done: vcgpdm 2 1 true 9";

describe("Vite", () => {
  for (const version of ["5", "6", "7", "8"]) {
    // The README asks for this setting for the development server of versions 5 to 7.
    const excluded = version === "8" ? "" : 'optimizeDeps: { exclude: ["vcgpdm"] },';
    const files = {
      "index.html": html("/app.js"),
      "app.js": app(),
      "worker/index.html": html("/worker/app.js"),
      "worker/app.js": withWorker,
      "worker/worker.js": worker,
      "train/index.html": html("/train/app.js"),
      "train/app.js": withTrain,
      "vite.config.js": `export default { ${excluded} worker: { format: "es" }, build: { target: "es2022", rollupOptions: { input: ["index.html", "worker/index.html", "train/index.html"] } } };\n`,
    };
    client(
      `${version}: build and development server, page and worker`,
      [`vite@${version}`],
      files,
      async (folder) => {
        await tool(folder, "vite", "build");
        assert.match(await titleIn(join(folder, "dist")), DONE);
        await withServer(folder, "vite", ["--host", "127.0.0.1", "--port", "0"], async (address) => {
          assert.match(await titleOf(address), DONE);
          assert.equal(await titleOf(`${address}worker/`), "done: vcgpdm model");
          assert.equal(await titleOf(`${address}train/`), TRAINED);
          return "";
        });
      },
    );
  }
});

describe("other bundlers", () => {
  const page = { "index.html": html("./main.js"), "app.js": app() };
  client(
    "webpack 5",
    ["webpack@5", "webpack-cli"],
    {
      ...page,
      "webpack.config.js":
        'export default { mode: "production", entry: "./app.js", experiments: { topLevelAwait: true } };\n',
    },
    async (folder) => {
      await tool(folder, "webpack");
      await run(
        folder,
        process.execPath,
        "-e",
        'require("fs").copyFileSync("index.html", "dist/index.html")',
      );
      assert.match(await titleIn(join(folder, "dist")), DONE);
    },
  );
  client(
    "esbuild, by the inlined entry",
    ["esbuild"],
    { ...page, "app.js": app("vcgpdm/inline") },
    async (folder) => {
      await tool(folder, "esbuild", "app.js", "--bundle", "--format=esm", "--outfile=main.js");
      assert.match(await titleIn(folder), DONE);
    },
  );
  const figure = `import init, { Clip, train } from "vcgpdm/inline";
import { Figure } from "vcgpdm/figure";
await init();
const model = await train(Clip.sample("walk-1").cut(0, 60), { ...${settings}, parts: "lower,upper" });
const figure = new Figure(document.querySelector("canvas"), model);
figure.play();
const wait = () => {
  if (figure.time > 0.3) document.title = "done: " + figure.alpha.length + " parts walk";
  else requestAnimationFrame(wait);
};
wait();
`;
  client(
    "esbuild, the figure and the inlined entry in one file",
    ["esbuild"],
    { "index.html": `${html("./main.js")}<canvas></canvas>\n`, "app.js": figure },
    async (folder) => {
      await tool(folder, "esbuild", "app.js", "--bundle", "--format=esm", "--outfile=main.js");
      assert.equal(await titleIn(folder), "done: 2 parts walk");
    },
  );
  const byUrl = app().replace("init()", "init(new URL(wasm, import.meta.url))");
  const byFile = `import wasm from "vcgpdm/vcgpdm_bg.wasm";\n${byUrl}`;
  client("esbuild, by the exported file", ["esbuild"], { ...page, "app.js": byFile }, async (folder) => {
    await tool(
      folder,
      "esbuild",
      "app.js",
      "--bundle",
      "--format=esm",
      "--outdir=.",
      "--entry-names=main",
      "--loader:.wasm=file",
    );
    assert.match(await titleIn(folder), DONE);
  });
  client(
    "Rollup, by the inlined entry",
    ["rollup", "@rollup/plugin-node-resolve"],
    {
      ...page,
      "app.js": app("vcgpdm/inline"),
      "rollup.config.js":
        'import resolve from "@rollup/plugin-node-resolve";\nexport default { input: "app.js", output: { file: "main.js", format: "es" }, plugins: [resolve({ browser: true })] };\n',
    },
    async (folder) => {
      await tool(folder, "rollup", "--config");
      assert.match(await titleIn(folder), DONE);
    },
  );
  client("Parcel 2", ["parcel@2"], { "index.html": html("./app.js"), "app.js": app() }, async (folder) => {
    await tool(folder, "parcel", "build", "index.html", "--no-cache", "--no-source-maps");
    assert.match(await titleIn(join(folder, "dist")), DONE);
  });
  const serverProgram = 'import { Clip } from "vcgpdm";\nconsole.log(Clip.sample("walk-1").info().frames);\n';
  client(
    "esbuild for Node, as module and by require, moved to another folder",
    ["esbuild"],
    { "app.js": serverProgram, "inline.js": serverProgram.replace('"vcgpdm"', '"vcgpdm/inline"') },
    async (folder) => {
      for (const program of ["app.js", "inline.js"])
        for (const [format, end] of [
          ["esm", "mjs"],
          ["cjs", "cjs"],
        ]) {
          const bundle = [
            "--bundle",
            "--platform=node",
            `--format=${format}`,
            `--outfile=moved/to/app.${end}`,
          ];
          await tool(folder, "esbuild", program, ...bundle);
          assert.equal(await run(join(folder, "moved/to"), process.execPath, `app.${end}`), "252\n");
        }
    },
  );
  client(
    "plain modules",
    [],
    { "index.html": html("./app.js"), "app.js": app("./node_modules/vcgpdm/web/vcgpdm.js") },
    async (folder) => assert.match(await titleIn(folder), DONE),
  );
});

describe("runtimes", () => {
  const modules =
    'import init, { Clip } from "vcgpdm";\nawait init();\nconsole.log(Clip.sample("walk-1").info().frames);\n';
  const common =
    'const { Clip, default: init } = require("vcgpdm");\ninit().then(() => console.log(Clip.sample("walk-1").info().frames));\n';
  const files = { "app.mjs": modules, "app.cjs": common };
  client("Node, as module, by require, and the other entries", [], files, async (folder) => {
    assert.equal(await run(folder, process.execPath, "app.mjs"), "252\n");
    assert.equal(await run(folder, process.execPath, "app.cjs"), "252\n");
    for (const entry of ["vcgpdm/inline", "vcgpdm/player"]) {
      const program = modules.replace('"vcgpdm"', `"${entry}"`);
      assert.equal(await run(folder, process.execPath, "--input-type=module", "-e", program), "252\n");
    }
    // Servers import what their pages show.
    const imported = 'import { Figure } from "vcgpdm/figure";\nconsole.log(typeof Figure);\n';
    assert.equal(await run(folder, process.execPath, "--input-type=module", "-e", imported), "function\n");
    const required = 'console.log(typeof require("vcgpdm/figure").Figure)';
    assert.equal(await run(folder, process.execPath, "--input-type=commonjs", "-e", required), "function\n");
  });
  for (const version of ["20.19", "22", "24"]) {
    client(`Node ${version}, as module and by require`, [`node@${version}`], files, async (folder) => {
      assert.match(await tool(folder, "node", "--version"), new RegExp(`^v${version}\\.`));
      for (const program of ["app.mjs", "app.cjs"])
        assert.equal(await tool(folder, "node", program), "252\n");
    });
  }
  client("Bun", ["bun"], files, async (folder) => {
    assert.equal(await tool(folder, "bun", "app.mjs"), "252\n");
    assert.equal(await tool(folder, "bun", "app.cjs"), "252\n");
  });
  client("Deno", ["deno"], files, async (folder) => {
    assert.match(await tool(folder, "deno", "run", "--allow-read", "app.mjs"), /252\n$/);
  });
  const test =
    'import init, { Clip } from "vcgpdm";\nimport { expect, test } from "vitest";\ntest("it", async () => {\n  await init();\n  expect(Clip.sample("walk-1").info().frames).toBe(252);\n});\n';
  client("Vitest", ["vitest"], { "it.test.js": test }, async (folder) => {
    assert.match(await tool(folder, "vitest", "run"), /1 passed/);
  });
});

describe("compilers and checkers", () => {
  const use =
    'import init, { Clip, type ErrorCode, type Model, Table } from "vcgpdm";\nawait init();\nconst clip: Clip = Clip.sample("walk-1");\nclip[Symbol.dispose]();\nexport const code: ErrorCode = "freed";\nexport const table = (model: Model): string => model.info().kind + Table.name;\n';
  const figure = ["vcgpdm", "vcgpdm/inline", "vcgpdm/player"]
    .map(
      (entry, i) => `import type { Model as Model${i} } from "${entry}";
export const show${i} = (canvas: HTMLCanvasElement, model: Model${i}) => new Figure(canvas, model, { dark: true });
`,
    )
    .join("");
  const checks = {
    "use.mts": use,
    "use-web.mts": use.replace('"vcgpdm"', '"vcgpdm/inline"'),
    "use-figure.mts": `import { Figure } from "vcgpdm/figure";\n${figure}`,
    "use-figure.cts": `import { Figure } from "vcgpdm/figure";\nexport const figures: Figure[] = [];\n`,
    "use-player.mts": 'import init from "vcgpdm/player";\nawait init();\n',
  };
  const strict = ["--noEmit", "--strict", "--skipLibCheck", "false", "--target", "es2022"];
  client("TypeScript, with the libraries checked", ["typescript"], checks, async (folder) => {
    for (const how of [
      ["--module", "nodenext"],
      ["--module", "esnext", "--moduleResolution", "bundler"],
    ])
      for (const lib of ["es2022,dom", "esnext,dom"])
        assert.equal(await tool(folder, "tsc", ...strict, ...how, "--lib", lib, ...Object.keys(checks)), "");
  });
  client("publint", ["publint"], {}, async (folder) => {
    assert.match(await tool(folder, "publint", "node_modules/vcgpdm", "--strict"), /All good/);
  });
  client("Are the types wrong?", ["@arethetypeswrong/cli"], {}, async (folder) => {
    const [packed] = (await run(folder, "npm", "pack", "./node_modules/vcgpdm", "--loglevel=error"))
      .trim()
      .split("\n")
      .slice(-1);
    // The wasm is a file and has no types.
    const printed = await tool(
      folder,
      "attw",
      packed ?? "",
      "--exclude-entrypoints",
      "./vcgpdm_bg.wasm",
      "--no-color",
      "--no-emoji",
    );
    assert.match(printed, /No problems found/);
  });
  client("npm publish, in a trial", [], {}, async (folder) => {
    const printed = await run(
      join(folder, "node_modules/vcgpdm"),
      "npm",
      "publish",
      "--dry-run",
      "--loglevel=warn",
    );
    const warnings = printed.split("\n").filter((line) => /^npm warn/i.test(line));
    // Of this machine's settings, and of nobody being logged in.
    assert.deepEqual(
      warnings.filter((line) => !/Unknown (user|env) config|logged in/.test(line)),
      [],
    );
    const packed = await run(
      join(folder, "node_modules/vcgpdm"),
      "npm",
      "pack",
      "--dry-run",
      "--json",
      "--loglevel=error",
    );
    const paths = JSON.parse(packed)[0].files.map((/** @type {{ path: string }} */ { path }) => path);
    const wasm = paths.filter((/** @type {string} */ path) => path.endsWith(".wasm"));
    assert.deepEqual(
      wasm.sort(),
      ["player/vcgpdm_bg.wasm", "web/vcgpdm_bg.wasm"],
      "the package has the wasm once, and the smaller one",
    );
  });
});
