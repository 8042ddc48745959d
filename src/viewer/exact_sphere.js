// The exact centre and squared radius of the smallest-dimensional sphere through points with doubles as coordinates.
// All numbers are BigInt: coordinates are integers over one power of two, and the centre is found by Cramer's rule in
// the affine hull of an affinely independent part of the points. The other points are taken to lie on the sphere, as
// those of a contact set do. Results are rationals {n, d}, reduced, with d > 0.

const view = new DataView(new ArrayBuffer(8));

// mantissa * 2^exponent, exactly.
export function parts_of_double(value) {
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const field = Number((bits >> 52n) & 0x7ffn);
  let mantissa = bits & 0xfffffffffffffn;
  if (field > 0) mantissa |= 1n << 52n;
  return { mantissa: bits >> 63n ? -mantissa : mantissa, exponent: (field > 0 ? field : 1) - 1075 };
}

const abs = (a) => (a < 0n ? -a : a);

function greatest_divisor(a, b) {
  a = abs(a);
  b = abs(b);
  while (b) [a, b] = [b, a % b];
  return a;
}

export function rational(n, d) {
  if (d < 0n) [n, d] = [-n, -d];
  const g = greatest_divisor(n, d);
  return g > 1n ? { n: n / g, d: d / g } : { n, d };
}

export const rational_text = ({ n, d }) => (d === 1n ? `${n}` : `${n}/${d}`);

const bit_length = (a) => a.toString(16).length * 4;

// The nearest double, ties to even: 64 bits of the quotient and a sticky bit decide it.
export function nearest_double({ n, d }) {
  if (n === 0n) return 0;
  const shift = BigInt(66 - bit_length(abs(n)) + bit_length(d));
  const [top, bottom] = shift >= 0n ? [abs(n) << shift, d] : [abs(n), d << -shift];
  let quotient = top / bottom;
  if (top % bottom) quotient |= 1n;
  // Below 2^-1022 doubles have fewer bits, so the quotient is cut to these first.
  const excess = -1074n - -shift - 2n;
  let exponent = -shift;
  if (excess > 0n) {
    const lost = quotient & ((1n << excess) - 1n);
    quotient >>= excess;
    if (lost) quotient |= 1n;
    exponent += excess;
  }
  let value = Number(quotient);
  for (let left = Number(exponent); left !== 0;) {
    const step = Math.max(-1000, Math.min(1000, left));
    value *= 2 ** step;
    left -= step;
  }
  return n < 0n ? -value : value;
}

// The root, nearly: the double of a fraction near 1 is taken, so that squares beyond the doubles have one as well.
export function near_root({ n, d }) {
  if (n === 0n) return 0;
  const half = Math.trunc((bit_length(n) - bit_length(d)) / 2);
  const near_one = nearest_double(half > 0 ? { n, d: d << BigInt(2 * half) } : { n: n << BigInt(-2 * half), d });
  return Math.sqrt(near_one) * 2 ** half;
}

// Whether the nearest double has all its digits.
export function is_normal(value) {
  const size = Math.abs(nearest_double(value));
  return value.n === 0n || (size >= 2 ** -1022 && size < Infinity);
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const inner = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const is_zero = (a) => a[0] === 0n && a[1] === 0n && a[2] === 0n;

// Points as integers over 2^-exponent.
function on_integer_grid(points) {
  const parts = points.map((point) => point.map(parts_of_double));
  let exponent = Infinity;
  for (const { mantissa, exponent: e } of parts.flat()) if (mantissa !== 0n) exponent = Math.min(exponent, e);
  if (exponent === Infinity) exponent = 0;
  const integer = ({ mantissa, exponent: e }) => (mantissa === 0n ? 0n : mantissa << BigInt(e - exponent));
  return { grid: parts.map((point) => point.map(integer)), exponent };
}

// At most three differences to the first point, linearly independent, that span all of them.
function spanning_differences(grid) {
  const basis = [];
  for (let i = 1; i < grid.length && basis.length < 3; ++i) {
    const v = minus(grid[i], grid[0]);
    const independent =
      basis.length === 0
        ? !is_zero(v)
        : basis.length === 1
          ? !is_zero(cross(basis[0], v))
          : inner(cross(basis[0], basis[1]), v) !== 0n;
    if (independent) basis.push(v);
  }
  return basis;
}

function determinant(m) {
  if (m.length === 0) return 1n;
  if (m.length === 1) return m[0][0];
  if (m.length === 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return inner(cross(m[0], m[1]), m[2]);
}

// {center: [x, y, z], squared, dimension}, of the affine hull.
export function exact_sphere(points) {
  const { grid, exponent } = on_integer_grid(points);
  const basis = spanning_differences(grid);
  const gram = basis.map((a) => basis.map((b) => 2n * inner(a, b)));
  const right = basis.map((a) => inner(a, a));
  const below = determinant(gram);
  const offset = [0n, 0n, 0n];
  basis.forEach((v, k) => {
    const factor = determinant(gram.map((row, i) => row.map((entry, j) => (j === k ? right[i] : entry))));
    for (let axis = 0; axis < 3; ++axis) offset[axis] += factor * v[axis];
  });
  const scaled = (n, d, power) => (power >= 0 ? rational(n << BigInt(power), d) : rational(n, d << BigInt(-power)));
  return {
    center: offset.map((value, axis) => scaled(grid[0][axis] * below + value, below, exponent)),
    squared: scaled(inner(offset, offset), below * below, 2 * exponent),
    dimension: basis.length,
  };
}
