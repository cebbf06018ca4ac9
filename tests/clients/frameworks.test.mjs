// The npm package in frameworks that render on the server and in the browser, and in bundles for Electron.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, describe } from "node:test";
import { clear, client, run, titleOf, tool, withServer } from "./packages.mjs";

after(clear);

const DONE = /^done: 252 frames/;
const SHORT = "{ latent: 1, dynamicsIps: 3, poseIps: 3, order: 1, framesPerSecond: 15, maxIterations: 2 }";
/** Trains, and gives the kind of the model and the frames of a rollout. */
const TRAINING = `const model = await train(Clip.sample("walk-1").cut(0, 60), ${SHORT});
const outcome = model.info().kind + " " + model.rollout({ frames: 9 }).frames;
`;

const text = async (/** @type {string} */ address) => (await fetch(address)).text();

describe("Next.js", () => {
  const files = {
    "app/layout.jsx": `export default function Layout({ children }) {
  return <html lang="en"><body>{children}</body></html>;
}
`,
    "app/page.jsx": `"use client";
import init, { Clip } from "vcgpdm";
import { useEffect } from "react";

export default function Page() {
  useEffect(() => {
    init().then(() => { document.title = "done: " + Clip.sample("walk-1").info().frames + " frames"; });
  }, []);
  return <p>A walk</p>;
}
`,
    "app/server/page.jsx": `import { Clip } from "vcgpdm";

export const dynamic = "force-dynamic";

export default function Page() {
  return <p>{"frames: " + Clip.sample("walk-1").info().frames}</p>;
}
`,
    "app/train/route.js": `import { Clip, train } from "vcgpdm";

export const dynamic = "force-dynamic";

export async function GET() {
  ${TRAINING}  return new Response(outcome);
}
`,
  };
  const external = 'export default { serverExternalPackages: ["vcgpdm"] };\n';
  for (const [version, title, settings] of [
    ["15", "component of the client and of the server, route that trains", [""]],
    ["16", "the same, and as an external package of the server", ["", external]],
  ])
    client(`${version}: ${title}`, [`next@${version}`, "react@19", "react-dom@19"], files, async (folder) => {
      for (const config of settings ?? []) {
        if (config) writeFileSync(join(folder, "next.config.mjs"), config);
        await tool(folder, "next", "build");
        await withServer(folder, "next", ["start", "--port", "0"], async (address) => {
          assert.match(await titleOf(address), DONE);
          assert.match(await text(`${address}server`), /frames: 252/);
          assert.equal(await text(`${address}train`), "vcgpdm 9");
          return "";
        });
      }
    });
});

describe("SvelteKit", () => {
  const files = {
    "svelte.config.js":
      'import adapter from "@sveltejs/adapter-node";\nexport default { kit: { adapter: adapter() } };\n',
    "vite.config.js":
      'import { sveltekit } from "@sveltejs/kit/vite";\nexport default { plugins: [sveltekit()] };\n',
    "src/app.html":
      '<!doctype html>\n<html lang="en"><head>%sveltekit.head%</head><body><div>%sveltekit.body%</div></body></html>\n',
    "src/routes/+page.server.js": `import { Clip } from "vcgpdm";
export const load = () => ({ frames: Clip.sample("walk-1").info().frames });
`,
    "src/routes/+page.svelte": `<script>
  import init, { Clip, train } from "vcgpdm";
  import { onMount } from "svelte";
  let { data } = $props();
  onMount(async () => {
    let workers = 0;
    const Plain = globalThis.Worker;
    globalThis.Worker = class extends Plain {
      constructor(...given) {
        super(...given);
        workers += 1;
      }
    };
    await init();
    ${TRAINING}    document.title = "done: " + outcome + " " + workers;
  });
</script>

<p>frames: {data.frames}</p>
`,
    "start.js": `import { createServer } from "node:http";
import { handler } from "./build/handler.js";
const server = createServer(handler).listen(0, "127.0.0.1", () => {
  console.log("http://127.0.0.1:" + server.address().port + "/");
});
`,
  };
  const tools = [
    "@sveltejs/kit@2",
    "@sveltejs/adapter-node@5",
    "@sveltejs/vite-plugin-svelte@6",
    "svelte@5",
    "vite@7",
  ];
  client("2: adapter-node, on the server and with `train` in a worker", tools, files, async (folder) => {
    await tool(folder, "vite", "build");
    await withServer(folder, process.execPath, ["start.js"], async (address) => {
      assert.match(await text(address), /frames: 252/);
      assert.equal(await titleOf(address), "done: vcgpdm 9 1");
      return "";
    });
  });
});

describe("Electron", () => {
  const program = `import init, { Clip, train } from "vcgpdm";
await init();
${TRAINING}document.title = "done: " + outcome;
console.log(document.title);
`;
  const files = {
    "app.js": program,
    // The renderer has a document and the modules of Node; the main process has the modules alone.
    "run.cjs": 'globalThis.document = {};\nrequire("./dist/" + process.argv[2] + ".cjs");\n',
    "webpack.config.js": `const target = (target) => ({
  mode: "production", entry: "./app.js", target, experiments: { topLevelAwait: true },
  output: { filename: target + ".cjs", publicPath: "" },
});
export default [target("electron-main"), target("electron-renderer")];
`,
  };
  client(
    "webpack's bundles for the main process and the renderer",
    ["webpack@5", "webpack-cli"],
    files,
    async (folder) => {
      await tool(folder, "webpack");
      for (const target of ["electron-main", "electron-renderer"])
        assert.equal(await run(folder, process.execPath, "run.cjs", target), "done: vcgpdm 9\n");
    },
  );
});
