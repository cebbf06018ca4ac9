// The front end of vcgpdm.widget: a walking figure, its couplings as sliders, a button. scripts/widget.mjs
// makes one file of it, with wasm and figure inside, for anywidget in Jupyter, Colab, marimo and VS Code.
import { Figure } from "vcgpdm/figure";
import init, { Model } from "vcgpdm/player";
import packed from "virtual:wasm";

/** Each slider goes from a thousandth to a thousand times the learned variance. */
const DECADES = 3;

const STYLE = `
.vcgpdm { font: 13px/1.4 system-ui, sans-serif; max-width: 960px; }
.vcgpdm canvas { display: block; width: 100%; border-radius: 6px; }
.vcgpdm-row { display: flex; flex-wrap: wrap; gap: 4px 16px; align-items: center; padding: 6px 0; }
.vcgpdm label { display: flex; gap: 6px; align-items: center; }
.vcgpdm button { padding: 2px 12px; border: 1px solid #8888; border-radius: 6px; }
.vcgpdm output { min-width: 5em; font-variant-numeric: tabular-nums; }
`;

/** @type {Promise<unknown> | undefined} */
let started;

/** Unpacks and starts the wasm, once for all figures of a page. */
function start() {
  started ??= (async () => {
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    await init({ module_or_path: await new Response(stream).arrayBuffer() });
  })();
  return started;
}

function element(name, properties, ...children) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

/** A slider for the coupling from part `source` to part `target`. */
function slider(names, learned, [source, target], changed) {
  const label = source === target ? `${names[source]} itself` : `${names[source]} → ${names[target]}`;
  const input = element("input", { type: "range", min: -DECADES, max: DECADES, step: 0.01 });
  const output = element("output", {});
  const show = (alpha) => {
    input.value = Math.log10(alpha[source][target] / learned[source][target]);
    output.textContent = alpha[source][target].toPrecision(3);
  };
  input.oninput = () => changed(source, target, learned[source][target] * 10 ** Number(input.value));
  return { node: element("label", { title: "coupling variance alpha" }, label, input, output), show };
}

async function render({ model: state, el }) {
  await start();
  const body = Model.fromJson(state.get("document"));
  const { parts, alpha: learned } = body.info();
  const names = parts.map((part) => part.name);
  const canvas = element("canvas", { tabIndex: 0 });
  canvas.style.height = `${state.get("height")}px`;
  const problem = element("p", { role: "alert", hidden: true });
  const button = element("button", { type: "button" });
  const row = element("div", { className: "vcgpdm-row" }, button);
  const place = element("div", { className: "vcgpdm" }, element("style", {}, STYLE), canvas, row, problem);
  el.append(place);

  const show = (error) => {
    problem.hidden = !error;
    problem.textContent = error ? error.message : "";
  };
  const options = { alpha: state.get("alpha"), seconds: state.get("seconds"), samples: state.get("samples") };
  let figure;
  try {
    figure = new Figure(canvas, body, options);
  } catch (error) {
    show(error);
    return () => body.free();
  }
  const sliders = names.flatMap((_, target) =>
    names.map((_, source) =>
      slider(names, learned, [source, target], (source, target, value) => {
        const alpha = state.get("alpha").map((row) => [...row]);
        alpha[source][target] = value;
        state.set("alpha", alpha);
        state.save_changes();
      }),
    ),
  );
  if (names.length > 1) row.append(...sliders.map(({ node }) => node));
  const follow = {
    alpha() {
      const alpha = state.get("alpha");
      try {
        figure.alpha = alpha;
        show(null);
      } catch (error) {
        show(error);
      }
      for (const slider of sliders) slider.show(alpha);
    },
    playing() {
      if (state.get("playing")) figure.play();
      else figure.pause();
      button.textContent = figure.playing ? "Pause" : "Play";
    },
  };
  button.onclick = () => {
    state.set("playing", !state.get("playing"));
    state.save_changes();
  };
  for (const [name, changed] of Object.entries(follow)) {
    changed();
    state.on(`change:${name}`, changed);
  }
  return () => {
    for (const [name, changed] of Object.entries(follow)) state.off(`change:${name}`, changed);
    figure.dispose();
    body.free();
  };
}

export default { render };
