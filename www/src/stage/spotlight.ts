// The frames that an inducing point lights up.

/**
 * The brightness of each frame, 0 to 1, from the weight of the point in it. Frames of large weight stand out.
 */
export function spotlight(shares: Float64Array): Float64Array {
  const spoken = shares.filter((share) => share > 0).sort();
  const top = spoken.at(-1);
  if (top === undefined) return new Float64Array(shares.length);
  const middle = spoken[Math.floor(spoken.length / 2)] ?? top;
  const low = Math.min(middle, 0.97 * top);
  return shares.map((share) => {
    const above = Math.max(0, (share - low) / (top - low));
    // A point far from all frames has little weight in each.
    return above * above * Math.min(1, top / 0.3);
  });
}
