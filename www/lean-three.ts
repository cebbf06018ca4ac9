// three.js without what the page cannot use: a tenth less to download.
//
// three's renderer names all it can do, so that a bundler must keep it: headsets, environment maps, the
// shaders of materials that nobody makes here. Built from three's sources, these files are replaced, and the
// comments in the shaders are left out. A stub that meets no file any more, because three has moved it, ends
// the build.
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

/**
 * The materials of the page, and the shadows: MeshStandardMaterial, ShadowMaterial and ShaderMaterials of its
 * own.
 */
const SHADERS_USED = /\/ShaderLib\/(meshphysical|shadow|depth)\.glsl\.js$/;

const STUBS: [file: RegExp, code: string][] = [
  [
    /\/renderers\/webxr\/WebXRManager\.js$/,
    `export class WebXRManager {
      enabled = false; isPresenting = false; cameraAutoUpdate = false;
      addEventListener() {} removeEventListener() {} setAnimationLoop() {} dispose() {} updateCamera() {} getCamera() {}
      hasDepthSensing() { return false; } getDepthSensingMesh() { return null; } getEnvironmentBlendMode() { return "opaque"; }
    }`,
  ],
  [/\/extras\/PMREMGenerator\.js$/, "export class PMREMGenerator { dispose() {} }"],
];

/** GLSL without comments, indentation and empty lines. */
const bare = (shader: string) =>
  shader
    .replace(/\/\*[\s\S]*?\*\//g, "")
    .replace(/\/\/[^\n]*/g, "")
    .split("\n")
    .map((line) => line.trim())
    .filter(Boolean)
    .join("\n");

export function leanThree(): Plugin {
  // three/build/three.cjs
  const sources = join(dirname(createRequire(import.meta.url).resolve("three")), "../src");
  const met = new Set<RegExp>();
  return {
    name: "lean-three",
    apply: "build",
    enforce: "pre",
    resolveId: (id) => (id === "three" ? join(sources, "Three.js") : null),
    transform(code, id) {
      const file = id.replaceAll("\\", "/");
      const stub = STUBS.find(([name]) => name.test(file));
      if (stub) {
        met.add(stub[0]);
        return stub[1];
      }
      if (!/\/shaders\/Shader(Lib|Chunk)\/[^/]*\.glsl\.js$/.test(file)) return null;
      if (file.includes("/ShaderLib/") && !SHADERS_USED.test(file))
        return 'export const vertex = "";\nexport const fragment = "";';
      return code.replace(/`([^`]*)`/g, (_, shader: string) => `\`${bare(shader)}\``);
    },
    buildEnd() {
      const missed = STUBS.find(([name]) => !met.has(name));
      // The workers are built too, and have no three.
      if (met.size > 0 && missed) this.error(`lean-three.ts: three has no file ${missed[0]} any more`);
    },
  };
}
