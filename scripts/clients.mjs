// `npm run test:clients`: programs of others that use ours: workflows, bundlers, runtimes. What they need is
// installed into .tools and into fresh folders; what the registries do not give says that it skipped. `npm
// run test:clients -- NAME` runs one file of tests/clients.
import { compileTests } from "./cargo.mjs";
import { buildWasm } from "./wasm.mjs";
import { at, Failure, filesUnder, main, run, step } from "./run.mjs";
import { install } from "./python.mjs";
import { installTools } from "./tools.mjs";

await main(async () => {
  const name = process.argv[2] ?? "";
  const files = filesUnder([at("tests/clients")]).filter((file) => file.endsWith(`${name}.test.mjs`));
  if (files.length === 0) throw new Failure(`expected one of the files in tests/clients, found ${name}`);
  await installTools();
  await step("npm package", buildWasm);
  // As `npm test` compiles it: after that it is there.
  await step("the program vcgpdm", compileTests);
  await step("Python packages in .tools/clients", async () => {
    try {
      return await install("clients", at("tests/clients/requirements.txt"));
    } catch (error) {
      if (error instanceof Failure) return `skipped: ${error.message}`;
      throw error;
    }
  });
  await run(process.execPath, "--test", "--test-reporter=spec", "--test-concurrency=1", ...files);
});
