// The histogram of radii of index-2 points, or of the persistence of their pairs, and the threshold in it.
// Bars have a logarithmic height; those that the threshold keeps are in full colour. A drag over bars brushes the pairs
// of these points. `value_at` and `part_of` join the slider below to the same axis. Values are in the frame, and are
// written in input units.

import { Scale, fresh_context } from './plot.js';
import { none } from './point_numbers.js';
import { RectangleBrush } from './rectangle_brush.js';
import { count_text } from './words.js';

const margin = { left: 56, right: 10, top: 8, bottom: 32 };
const bins = 56;

export class Histogram {
  constructor(canvas, complex, state, actions) {
    Object.assign(this, { canvas, complex, state, actions });
    this.brush = new RectangleBrush(canvas, {
      whole_height: true,
      brushed: (rectangle) => this.brush_range(rectangle),
      clicked: (x) => this.x && actions.threshold(this.x.value(x)),
    });
  }

  values() {
    return this.state.mode === 'radius' ? this.complex.set_radius : this.complex.set_persistence;
  }

  // Bounds of the positive values; the axis is logarithmic where these spread over more than a factor of 4.
  axis() {
    if (this.axis_of === this.state.mode) return this.bounds;
    let [low, high] = [Infinity, 0];
    for (const value of this.values())
      if (value > 0 && value < Infinity) [low, high] = [Math.min(low, value), Math.max(high, value)];
    if (high === 0) [low, high] = [0, 1];
    const log = low > 0 && high / low > 4;
    this.axis_of = this.state.mode;
    this.bounds = log
      ? { low: low / (high / low) ** 0.02, high: high * (high / low) ** 0.02, log }
      : { low: 0, high: high * 1.05, log };
    return this.bounds;
  }

  scale(from, to) {
    return new Scale({ ...this.axis(), from, to });
  }

  // 0 to 1 along the axis, and back.
  value_at(part) {
    return this.scale(0, 1).value(part);
  }

  part_of(value) {
    return value === Infinity ? 1 : value <= 0 ? 0 : Math.max(0, Math.min(1, this.scale(0, 1).pixel(value)));
  }

  counts() {
    const counts = new Float64Array(bins);
    for (const value of this.values())
      if (value >= 0 && value < Infinity) ++counts[Math.min(bins - 1, Math.floor(this.part_of(value) * bins))];
    return counts;
  }

  draw(palette, ratio) {
    const { canvas, state } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width < 80 || height < 60) return;
    Object.assign(this, { palette, ratio });
    this.x = this.scale(margin.left, width - margin.right);
    if (this.counted !== state.mode) [this.counted, this.bars] = [state.mode, this.counts()];
    const context = fresh_context(canvas, ratio);
    const most = Math.max(1, ...this.bars);
    const bottom = height - margin.bottom;
    const tall = (count) => ((bottom - margin.top) * Math.log1p(count)) / Math.log1p(most);
    this.draw_axes(context, width, bottom, most, tall);
    for (let i = 0; i < bins; ++i) this.draw_bar(context, i, bottom, tall(this.bars[i]));
    this.draw_limit(context, bottom);
    this.draw_rectangle(context, bottom);
  }

  draw_axes(context, width, bottom, most, tall) {
    const { palette, x } = this;
    context.fillStyle = palette.muted;
    context.strokeStyle = palette.grid;
    context.textAlign = 'right';
    for (let count = 1; count <= most; count *= most > 1000 ? 100 : 10) {
      const y = bottom - tall(count);
      context.fillRect(margin.left - 3, y, 3, 1);
      context.fillText(count_text(count), margin.left - 6, y + 4);
    }
    context.textAlign = 'center';
    const { complex } = this;
    for (const tick of x.ticks(6, complex.length_unit.factor))
      context.fillText(complex.length_text(tick), x.pixel(tick), bottom + 14);
    const name =
      this.state.mode === 'radius'
        ? 'distance of index-2 points, input units'
        : 'persistence of their pairs, input units';
    context.fillText(name, (margin.left + width) / 2, bottom + 28);
    context.fillRect(margin.left, bottom, width - margin.left - margin.right, 1);
  }

  draw_bar(context, i, bottom, tall) {
    if (tall === 0) return;
    const { state, palette } = this;
    const [from, to] = [this.x.pixel(this.value_at(i / bins)), this.x.pixel(this.value_at((i + 1) / bins))];
    const middle = this.value_at((i + 0.5) / bins);
    const kept = state.mode === 'radius' ? middle < state.limit : middle > state.limit;
    context.fillStyle = palette.kinds[2];
    context.globalAlpha = kept ? 1 : 0.28;
    context.fillRect(from + 0.5, bottom - tall, Math.max(1, to - from - 1), tall);
    context.globalAlpha = 1;
    if (this.bin_of_picked() !== i) return;
    context.strokeStyle = palette.ink;
    context.lineWidth = 2;
    context.strokeRect(from + 0.5, bottom - tall, Math.max(1, to - from - 1), tall);
  }

  bin_of_picked() {
    const { state, complex } = this;
    if (state.picked === none) return -1;
    const pair = complex.pair_of[state.picked];
    const ends = pair === none ? [state.picked] : [complex.birth[pair], complex.death[pair]];
    const set = ends
      .filter((p) => p !== none)
      .map((p) => complex.set_of_point[p])
      .find((s) => s !== none);
    return set === undefined ? -1 : Math.min(bins - 1, Math.floor(this.part_of(this.values()[set]) * bins));
  }

  draw_limit(context, bottom) {
    const { state, palette, x } = this;
    if (state.limit === Infinity || state.limit < 0) return;
    const at = x.pixel(Math.max(x.low, Math.min(x.high, state.limit)));
    context.strokeStyle = palette.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(at, margin.top - 4);
    context.lineTo(at, bottom);
    context.stroke();
  }

  draw_rectangle(context, bottom) {
    const { rectangle } = this.brush;
    if (!rectangle || !this.state.brush) return;
    context.fillStyle = this.palette.accent;
    context.globalAlpha = 0.16;
    context.fillRect(rectangle.left, margin.top, rectangle.right - rectangle.left, bottom - margin.top);
    context.globalAlpha = 1;
  }

  brush_range(rectangle) {
    if (!rectangle || !this.x) return this.actions.brush(null);
    const { complex, x } = this;
    // The first bar has 0 as well, which a logarithmic axis has not.
    const first = x.pixel(this.value_at(0.5 / bins));
    const place = (value) => (value > 0 ? x.pixel(value) : first);
    const values = this.values();
    const inside = new Uint8Array(complex.pair_count);
    for (let set = 0; set < values.length; ++set) {
      const pair = complex.pair_of[complex.set_point[set]];
      const at = place(values[set]);
      if (pair !== none && at >= rectangle.left && at <= rectangle.right) inside[pair] = 1;
    }
    this.actions.brush((pair) => inside[pair] === 1, this);
  }
}
