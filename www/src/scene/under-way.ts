// A movement on the spot, put on its way over the ground.
import type { Motion } from "../engine/protocol";
import type { ColumnMotion } from "./columns";

/** The movement over the ground at this speed, in this heading: 0 is along z. The camera goes with it. */
export function underWay(motion: Motion, speed: number, heading: number): ColumnMotion {
  const positions = motion.positions.slice();
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const each = 3 * motion.nodes;
  for (let i = 0; i < positions.length; i += 3) {
    const way = speed * motion.frameTime * Math.floor(i / each);
    const [x, z] = [positions[i]!, positions[i + 2]! + way];
    positions[i] = c * x + s * z;
    positions[i + 2] = c * z - s * x;
  }
  return { motion: { ...motion, positions }, ghost: null, camera: { x: s * speed, z: c * speed } };
}
