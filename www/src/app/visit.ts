// What a visit holds that can be kept, and how it is taken up by the next.
import type { Holdings } from "../session/records";
import type { Visit } from "../session/session-store";
import { stageWork } from "../couplings/model-work";
import { mayLose } from "../ui/unsaved";
import type { App } from "./app";

/** What the clips of runs are called that are not open any more: no other clip has such a number. */
let lastGone = 0;

export function visitOf(app: App): Visit {
  return {
    holdings(): Holdings {
      const { settings, clips, training, model, comparison, primitives } = app;
      const shown = comparison.loaded?.shown;
      const ids = new Map(clips.all.map(({ key, loaded }) => [key, loaded.id]));
      return {
        fragment: settings.address.fragment.replace(/^#/, ""),
        clips: clips.kept.map((clip) => ({ ...clip, id: ids.get(clip.key) ?? 0 })),
        firstBones: clips.firstBones,
        runs: training.runs,
        chosen: training.chosen,
        model: training.chosen ? null : model.opened,
        results: shown && !shown.given ? shown.results.text : null,
        unsaved: {
          model: model.unsaved,
          results: comparison.loaded?.unsaved.some((entry) => entry === shown) ?? false,
        },
        library: primitives.loaded?.library.kept ?? null,
      };
    },
    async takeUp({ fragment, clips, firstBones, runs, chosen, model, results, unsaved, library }) {
      const { settings } = app;
      const kept = () => new Error("You keep what is here.");
      if (results !== null && !(await (await app.comparison.get()).open(results, !unsaved.results)))
        throw kept();
      if ((model !== null || chosen?.model) && !(await mayLose(stageWork(app.model, app.engine))))
        throw kept();
      if (settings.address.fragment.replace(/^#/, "") === "" && fragment !== "") {
        settings.takeFragment(fragment);
        app.model.restart();
      }
      const numbers = await app.clips.takeUp(clips, firstBones);
      const now = new Map(clips.map(({ key, id }) => [id, numbers.get(key)]));
      const known = runs.map((run) => ({
        ...run,
        clips: run.clips.map((clip) => {
          if (now.get(clip.id) === undefined) now.set(clip.id, --lastGone);
          return { ...clip, id: now.get(clip.id) ?? lastGone };
        }),
      }));
      await app.training.takeUp(known, chosen ? runs.indexOf(chosen) : -1);
      if (model !== null) await app.model.open(model, { couplings: "visitor", clip: true });
      if (model !== null && unsaved.model) app.model.standsAlone();
      if (library !== null) {
        const { text, title, unsaved } = library;
        await (await app.primitives.get()).library.open(text, title, unsaved);
      }
    },
    tell: (title, text) => app.notices.addError(title, text),
  };
}
