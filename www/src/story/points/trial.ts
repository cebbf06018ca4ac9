import type { KeptReport } from "../../engine/whole-protocol";
import type { LegPoints } from "./elimination";

/** The walk with some of the points. */
export interface Trial {
  points: LegPoints;
  count: number;
  bound: number;
  /** Mean distance of the joints from the walk with all points, in metres. */
  error: number;
  stumbles: boolean;
  report: KeptReport;
}
