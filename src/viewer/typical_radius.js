// A radius that separates small S2, the shape, from large ones: the deepest valley behind the highest peak of the
// histogram of logarithms of the radii. Infinity where there is no such valley, so that nothing is left out.

const bins = 64;

export function typical_radius(radii) {
  const positive = radii.filter((radius) => radius > 0 && radius < Infinity);
  if (positive.length < 200) return Infinity;
  let [low, high] = [Infinity, 0];
  for (const radius of positive) [low, high] = [Math.min(low, radius), Math.max(high, radius)];
  const span = Math.log(high / low);
  if (span < 0.5) return Infinity;
  const raw = new Float64Array(bins);
  for (const radius of positive) ++raw[Math.min(bins - 1, Math.floor((Math.log(radius / low) / span) * bins))];
  const counts = raw.map((count, i) => (raw[Math.max(0, i - 1)] + 2 * count + raw[Math.min(bins - 1, i + 1)]) / 4);
  const peak = counts.indexOf(Math.max(...counts));
  let [valley, best] = [-1, 3];
  for (let i = peak + 1; i < bins - 1; ++i) {
    const beyond = Math.max(...counts.subarray(i + 1));
    const depth = beyond / (counts[i] + 0.5);
    if (beyond > counts[peak] / 1000 && depth > best) [valley, best] = [i, depth];
    if (valley >= 0 && counts[i] > 3 * counts[valley] + 3) break;
  }
  return valley < 0 ? Infinity : low * Math.exp(((valley + 0.5) / bins) * span);
}
