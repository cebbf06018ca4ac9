// The projection of latent spaces to plots: principal axes, and their rotation. For drawing only.

export interface Projection {
  /** The middle of the points [Q]. */
  centre: Float64Array;
  /** Three orthonormal rows, the widest spread first [3 x Q]; rows beyond Q are zero. */
  axes: Float64Array;
  /** Half the largest width of the cloud from any side, for scaling. */
  reach: number;
  /** Half the width and height of the cloud, seen along the third axis. */
  flat: [right: number, up: number];
  dimensions: number;
}

/** Principal axes of points [n x q]. Axes keep the signs of `before`, so that plots do not flip. */
export function principalAxes(points: Float64Array, q: number, before?: Projection | null): Projection {
  const n = q > 0 ? Math.floor(points.length / q) : 0;
  const centre = new Float64Array(q);
  for (let i = 0; i < n * q; i++) centre[i % q]! += points[i]! / n;
  const spread = new Float64Array(q * q);
  for (let t = 0; t < n; t++) {
    for (let a = 0; a < q; a++) {
      const da = points[t * q + a]! - centre[a]!;
      for (let b = 0; b < q; b++) spread[a * q + b]! += (da * (points[t * q + b]! - centre[b]!)) / n;
    }
  }
  const { values, vectors } = symmetricEigen(spread, q);
  const order = [...values.keys()].sort((a, b) => values[b]! - values[a]!);
  const axes = new Float64Array(3 * q);
  for (let k = 0; k < Math.min(3, q); k++) {
    for (let a = 0; a < q; a++) axes[k * q + a] = vectors[a * q + order[k]!]!;
  }
  if (before && before.dimensions === q) alignAxes(axes, before.axes, q);
  const projection = { centre, axes, reach: 1, flat: [1, 1] as [number, number], dimensions: q };
  const at = new Float64Array(3);
  let [reach, right, up] = [0, 0, 0];
  for (let t = 0; t < n; t++) {
    project(projection, points, t, at);
    reach = Math.max(reach, Math.hypot(at[0]!, at[1]!), Math.abs(at[2]!));
    [right, up] = [Math.max(right, Math.abs(at[0]!)), Math.max(up, Math.abs(at[1]!))];
  }
  if (reach > 1e-9) [projection.reach, projection.flat] = [reach, [right, up]];
  return projection;
}

/** Rotates the first two axes, and flips the third, to fit the axes before. */
function alignAxes(axes: Float64Array, before: Float64Array, q: number): void {
  const dot = (i: number, j: number) => {
    let sum = 0;
    for (let a = 0; a < q; a++) sum += axes[i * q + a]! * before[j * q + a]!;
    return sum;
  };
  if (q > 1) {
    if (dot(0, 0) * dot(1, 1) - dot(0, 1) * dot(1, 0) < 0) {
      for (let a = 0; a < q; a++) axes[q + a] = -axes[q + a]!;
    }
    const angle = Math.atan2(dot(0, 1) - dot(1, 0), dot(0, 0) + dot(1, 1));
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    for (let a = 0; a < q; a++) {
      const [u, v] = [axes[a]!, axes[q + a]!];
      axes[a] = c * u - s * v;
      axes[q + a] = s * u + c * v;
    }
  } else if (q === 1 && dot(0, 0) < 0) {
    axes[0] = -axes[0]!;
  }
  if (q > 2 && dot(2, 2) < 0) for (let a = 0; a < q; a++) axes[2 * q + a] = -axes[2 * q + a]!;
}

/** Row `index` of points [n x q] on the three axes. */
export function project(
  projection: Projection,
  points: Float64Array,
  index: number,
  out: Float64Array,
): Float64Array {
  const { centre, axes, dimensions: q } = projection;
  for (let k = 0; k < 3; k++) {
    let sum = 0;
    for (let a = 0; a < q; a++) sum += axes[k * q + a]! * (points[index * q + a]! - centre[a]!);
    out[k] = sum;
  }
  return out;
}

/** Eigenvalues and eigenvectors (columns) of a symmetric matrix [q x q], by Jacobi rotations. */
export function symmetricEigen(
  matrix: Float64Array,
  q: number,
): { values: Float64Array; vectors: Float64Array } {
  const m = matrix.slice();
  const vectors = new Float64Array(q * q);
  for (let i = 0; i < q; i++) vectors[i * q + i] = 1;
  for (let sweep = 0; sweep < 30; sweep++) {
    let off = 0;
    let all = 0;
    for (let i = 0; i < q * q; i++) {
      all += m[i]! ** 2;
      if (i % (q + 1) !== 0) off += m[i]! ** 2;
    }
    if (off <= 1e-24 * all) break;
    for (let a = 0; a < q; a++) {
      for (let b = a + 1; b < q; b++) {
        const apq = m[a * q + b]!;
        if (apq === 0) continue;
        const theta = (m[b * q + b]! - m[a * q + a]!) / (2 * apq);
        const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        const c = 1 / Math.sqrt(t * t + 1);
        const s = t * c;
        for (let k = 0; k < q; k++) {
          const [u, v] = [m[k * q + a]!, m[k * q + b]!];
          m[k * q + a] = c * u - s * v;
          m[k * q + b] = s * u + c * v;
        }
        for (let k = 0; k < q; k++) {
          const [u, v] = [m[a * q + k]!, m[b * q + k]!];
          m[a * q + k] = c * u - s * v;
          m[b * q + k] = s * u + c * v;
        }
        for (let k = 0; k < q; k++) {
          const [u, v] = [vectors[k * q + a]!, vectors[k * q + b]!];
          vectors[k * q + a] = c * u - s * v;
          vectors[k * q + b] = s * u + c * v;
        }
      }
    }
  }
  return { values: Float64Array.from({ length: q }, (_, i) => m[i * q + i]!), vectors };
}

/** The rotation of a plot: radians about the vertical and the horizontal axis of the screen. */
export interface Turn {
  about: number;
  tilt: number;
}

/** The point in coordinates of the screen: right, up, towards the viewer. */
export function turned(point: Float64Array, turn: Turn): [number, number, number] {
  const [x, y, z] = [point[0]!, point[1]!, point[2]!];
  const ca = Math.cos(turn.about);
  const sa = Math.sin(turn.about);
  const ct = Math.cos(turn.tilt);
  const st = Math.sin(turn.tilt);
  const right = ca * x + sa * z;
  const deep = ca * z - sa * x;
  return [right, ct * y - st * deep, st * y + ct * deep];
}
