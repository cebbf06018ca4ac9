// The couplings of the combination that walks, as a table of sliders.
import { couplingCell } from "../couplings/coupling-cell";
import { couplingsTable } from "../couplings/couplings-table";
import { weightOf } from "../couplings/shares";
import type { LibraryStore } from "./library-store";

export function combinationCouplings(library: LibraryStore) {
  const parts = (library.known?.info.parts ?? []).map(({ name }) => name);
  return couplingsTable({
    parts,
    cell: (source, target) => {
      const before = library.nearest[source]?.[target] ?? 1;
      return couplingCell({
        source,
        target,
        names: [parts[source] ?? "", parts[target] ?? ""],
        alpha: library.alpha[source]?.[target] ?? 1,
        before,
        learned: false,
        weight: weightOf(library.alpha, source, target),
        changed: false,
        prefix: "walk-",
        change: (alpha) => library.setCoupling(source, target, alpha),
        reset: () => library.setCoupling(source, target, before),
      });
    },
  });
}
