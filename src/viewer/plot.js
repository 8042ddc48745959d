// A canvas with axes: scales, ticks, and the way between values and pixels.
// A scale has strips of its own for 0 (where it is logarithmic) and for infinity.

export class Scale {
  // low, high: the least and the largest value that are drawn; from, to: pixels; strips: widths of zero and infinity.
  constructor({ low, high, log, from, to, zero = 0, infinite = 0 }) {
    if (!(high > low)) [low, high] = [log ? low / 2 || 0.5 : low - 0.5 * Math.abs(low) - (low === 0), high * 2 || 1];
    const sign = to > from ? 1 : -1;
    Object.assign(this, { low, high, log, from: from + sign * zero, to: to - sign * infinite });
    this.zero_at = from + (sign * zero) / 2;
    this.infinite_at = to - (sign * infinite) / 2;
    this.has_zero = zero > 0;
    this.has_infinite = infinite > 0;
  }

  part(value) {
    return this.log
      ? Math.log(value / this.low) / Math.log(this.high / this.low)
      : (value - this.low) / (this.high - this.low);
  }

  pixel(value) {
    if (value === Infinity) return this.infinite_at;
    if (this.log && !(value > 0)) return this.zero_at;
    return this.from + this.part(value) * (this.to - this.from);
  }

  // Pixels in the strips stand for 0 and infinity.
  value(pixel) {
    const t = (pixel - this.from) / (this.to - this.from);
    if (t > 1 && this.has_infinite && t > (1 + this.strip(this.infinite_at)) / 2) return Infinity;
    if (t < 0 && this.has_zero && t < this.strip(this.zero_at) / 2) return this.log ? 0 : this.low;
    return this.log ? this.low * (this.high / this.low) ** t : this.low + t * (this.high - this.low);
  }

  strip(pixel) {
    return (pixel - this.from) / (this.to - this.from);
  }

  // Values that are round numbers when they are multiplied by the factor.
  ticks(most, factor) {
    const [low, high] = [this.low * factor, this.high * factor];
    const ticks = this.log ? log_ticks(low, high, most) : even_ticks(low, high, most);
    return ticks.map((tick) => tick / factor);
  }
}

function even_ticks(low, high, most) {
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough) ?? 10 * power;
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high * (1 + 1e-12) && ticks.length < 50; ++i) ticks.push(i * step);
  return ticks;
}

function log_ticks(low, high, most) {
  const decades = Math.log10(high / low);
  const mantissas = decades < most / 3 ? [1, 2, 5] : [1];
  const skip = Math.max(1, Math.ceil(decades / most));
  const ticks = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e)
    for (const mantissa of mantissas) {
      const value = mantissa * 10 ** e;
      if (value >= low * 0.999 && value <= high * 1.001 && e % skip === 0) ticks.push(Number(value.toPrecision(3)));
    }
  return ticks.length > 1 ? ticks : even_ticks(low, high, most).filter((value) => value > 0);
}

// The first of the texts that is at most so wide, or else the last one.
export function fitting_text(context, texts, width) {
  return texts.find((text) => context.measureText(text).width <= width) ?? texts.at(-1);
}

// The canvas in pixels of the style sheet; returns its drawing context, empty.
export function fresh_context(canvas, ratio, read = false) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const context = canvas.getContext('2d', { willReadFrequently: read });
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = '11px system-ui, sans-serif';
  return context;
}
