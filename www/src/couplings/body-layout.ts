// Where the body map puts its nodes and arrows, in its own units.

export const WIDTH = 170;
export const HEIGHT = 190;
/** Radius of a node. */
export const NODE = 11;

export interface Spot {
  x: number;
  y: number;
}

/** Moves nodes that lie close together apart, within the map. */
export function drawApart(spots: readonly Spot[]): Spot[] {
  const apart = spots.map(({ x, y }) => ({ x, y }));
  const least = 52;
  for (let round = 0; round < 60; round++) {
    for (let i = 0; i < apart.length; i++) {
      for (let j = i + 1; j < apart.length; j++) {
        const [a, b] = [apart[i]!, apart[j]!];
        let [dx, dy] = [b.x - a.x, b.y - a.y];
        const gap = Math.hypot(dx, dy);
        if (gap >= least) continue;
        if (gap < 1e-3) [dx, dy] = [Math.cos(i), Math.sin(i)];
        const push = (0.5 * (least - gap)) / (gap < 1e-3 ? 1 : gap);
        a.x -= push * dx;
        a.y -= push * dy;
        b.x += push * dx;
        b.y += push * dy;
      }
    }
    for (const spot of apart) {
      spot.x = Math.min(WIDTH - 34, Math.max(34, spot.x));
      spot.y = Math.min(HEIGHT - 26, Math.max(26, spot.y));
    }
  }
  return apart;
}

/** From the rim of one node to the rim of the other, bowed to one side so that there and back do not overlap. */
export function bowPath(a: Spot, b: Spot): string {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const bow = Math.min(26, 0.32 * length);
  const [mx, my] = [(a.x + b.x) / 2 - bow * uy * 1.6, (a.y + b.y) / 2 + bow * ux * 1.6];
  const rim = (at: Spot, away: number) => {
    const [vx, vy] = [mx - at.x, my - at.y];
    const size = Math.hypot(vx, vy) || 1;
    return { x: at.x + (away * vx) / size, y: at.y + (away * vy) / size };
  };
  const from = rim(a, NODE + 1);
  const to = rim(b, NODE + 5);
  return `M${from.x.toFixed(1)} ${from.y.toFixed(1)}Q${mx.toFixed(1)} ${my.toFixed(1)} ${to.x.toFixed(1)} ${to.y.toFixed(1)}`;
}

/** A loop beside a node, on its outer side. */
export function loopPath({ x, y }: Spot): string {
  const side = x < WIDTH / 2 - 1 ? -1 : 1;
  const at = (angle: number, away: number) =>
    `${(x + side * away * Math.cos(angle)).toFixed(1)} ${(y - away * Math.sin(angle)).toFixed(1)}`;
  const rim = NODE + 1;
  return `M${at(0.75, rim)}C${at(0.62, 46)} ${at(-0.62, 46)} ${at(-0.62, rim + 5)}`;
}
