// `npm run test:clients`: tries the package, the files and the page in other people's programs: workflows,
// bundlers, runtimes, Firefox and WebKit. They are installed into .tools and into fresh folders; a test is
// skipped where its program cannot be had. `npm run test:clients -- NAME` runs one file of tests/clients.
import { build } from "./build.mjs";
import { compileTests } from "./cargo.mjs";
import { at, Failure, filesUnder, main, run, step, which } from "./run.mjs";
import { install } from "./python.mjs";
import { installCargoTool, installTools } from "./tools.mjs";

/** A step whose failure makes tests skip, not fail. */
const attempt = (/** @type {string} */ title, /** @type {() => Promise<string | void>} */ work) =>
  step(title, async () => {
    try {
      return await work();
    } catch (error) {
      if (error instanceof Failure) return `skipped: ${error.message}`;
      throw error;
    }
  });

await main(async () => {
  const name = process.argv[2] ?? "";
  const files = filesUnder([at("tests/clients")]).filter((file) => file.endsWith(`${name}.test.mjs`));
  if (files.length === 0) throw new Failure(`expected one of the files in tests/clients, found ${name}`);
  await installTools();
  await build();
  // With the same options as `npm test`, which leaves the program compiled.
  await step("the program vcgpdm", compileTests);
  await attempt("Python packages in .tools/clients", () =>
    install("clients", at("tests/clients/requirements.txt")),
  );
  if (which("firefox-esr") ?? which("firefox"))
    await attempt("geckodriver", () => installCargoTool("geckodriver", "0.37.1"));
  await run(process.execPath, "--test", "--test-reporter=spec", "--test-concurrency=1", ...files);
});
