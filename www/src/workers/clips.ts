// The clips of this worker's trainings. The next training mostly has the same clips.
import { Clip, TrainingSet } from "vcgpdm";
import { ClipReader } from "./clip-reader";

export const clips = new ClipReader({ Clip, TrainingSet });
