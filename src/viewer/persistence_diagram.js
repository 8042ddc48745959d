// The persistence diagram: each pair at its birth and death, as distances, written in input units; what lasts is in the
// strip at the top. Colour and shape tell the dimension. A rectangle brushes pairs, a click picks the nearest one.
// A few thousand pairs are drawn as marks, more as pixels, so that 100,000 pairs are there at once.

import { Scale, fitting_text, fresh_context } from './plot.js';
import { none } from './point_numbers.js';
import { RectangleBrush } from './rectangle_brush.js';

const margin = { left: 56, right: 10, top: 10, bottom: 36 };
const strip = 16;
const most_marks = 4000;

// What an axis shows, as far as there is room for it.
function axis_text(context, what, width, log) {
  const scale = log ? ', logarithmic' : '';
  const texts = [`${what}: distance, input units${scale}`, `${what}, input units${scale}`, `${what}${scale}`, what];
  return fitting_text(context, texts, width);
}

// The colours of dimensions are those of the points that give birth to them.
export class PersistenceDiagram {
  constructor(canvas, complex, state, actions) {
    Object.assign(this, { canvas, complex, state, actions, log: this.spreads_widely(complex) });
    this.birth = Float64Array.from({ length: complex.pair_count }, (_, i) => Math.sqrt(complex.birth_squared(i)));
    this.death = Float64Array.from({ length: complex.pair_count }, (_, i) => Math.sqrt(complex.death_squared(i)));
    this.brush = new RectangleBrush(canvas, {
      brushed: (rectangle) => this.brush_rectangle(rectangle),
      clicked: (x, y) => this.pick(x, y),
    });
    canvas.addEventListener('keydown', (event) => this.step(event));
    this.base = document.createElement('canvas');
  }

  spreads_widely(complex) {
    let low = Infinity;
    for (const value of complex.squared) if (value > 0 && value < low) low = value;
    return complex.largest_squared / low > 400;
  }

  // Least and largest value on an axis, a little apart from the frame; the largest is that of both.
  range(values) {
    let low = Infinity;
    for (const value of values) if (value > 0 && value < low) low = value;
    const high = Math.sqrt(this.complex.largest_squared);
    if (high === 0) return { low: 0, high: 1 };
    return this.log
      ? { low: Math.min(low, high / 2) / 1.15, high: high * 1.15 }
      : { low: -0.04 * high, high: high * 1.08 };
  }

  draw(palette, ratio) {
    this.palette = palette;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width < 80 || height < 80) return;
    const { log } = this;
    this.x = new Scale({
      ...this.range(this.birth),
      log,
      zero: log ? strip : 0,
      from: margin.left,
      to: width - margin.right,
    });
    this.y = new Scale({
      ...this.range(this.death),
      log,
      from: height - margin.bottom,
      to: margin.top,
      infinite: strip,
    });
    const context = fresh_context(this.base_for(width, height), ratio, this.birth.length > most_marks);
    this.draw_axes(context, width, height);
    if (this.birth.length > most_marks) this.draw_pixels(context, ratio);
    else this.draw_marks(context);
    this.ratio = ratio;
    this.overlay();
  }

  base_for(width, height) {
    Object.defineProperty(this.base, 'clientWidth', { value: width, configurable: true });
    Object.defineProperty(this.base, 'clientHeight', { value: height, configurable: true });
    return this.base;
  }

  draw_axes(context, width, height) {
    const { palette, x, y, complex } = this;
    const { factor } = complex.length_unit;
    context.fillStyle = palette.muted;
    context.strokeStyle = palette.grid;
    context.lineWidth = 1;
    context.textAlign = 'center';
    for (const tick of x.ticks(5, factor)) {
      line(context, x.pixel(tick), margin.top, x.pixel(tick), height - margin.bottom);
      if (x.pixel(tick) > x.zero_at + 24 || !this.log)
        context.fillText(complex.length_text(tick), x.pixel(tick), height - margin.bottom + 14);
    }
    if (this.log) context.fillText('0', x.zero_at, height - margin.bottom + 14);
    context.textAlign = 'right';
    for (const tick of y.ticks(5, factor)) {
      line(context, margin.left, y.pixel(tick), width - margin.right, y.pixel(tick));
      context.fillText(complex.length_text(tick), margin.left - 5, y.pixel(tick) + 4);
    }
    context.fillText('∞', margin.left - 6, y.infinite_at + 4);
    context.textAlign = 'center';
    context.fillText(axis_text(context, 'birth', width - margin.left, this.log), (margin.left + width) / 2, height - 6);
    context.save();
    context.translate(11, (height - margin.bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(axis_text(context, 'death', height - margin.bottom, this.log), 0, 0);
    context.restore();
    context.strokeStyle = palette.muted;
    const least = Math.max(x.low, y.low);
    line(context, x.pixel(least), y.pixel(least), x.pixel(x.high), y.pixel(y.high));
    context.strokeRect(
      margin.left,
      margin.top,
      width - margin.left - margin.right,
      height - margin.top - margin.bottom,
    );
  }

  draw_marks(context) {
    for (let i = 0; i < this.birth.length; ++i) this.mark(context, i, 4.2, this.palette.kinds[this.dimension(i)]);
  }

  dimension(pair) {
    return this.complex.pairs.dimension[pair];
  }

  pixel_of(pair) {
    return [this.x.pixel(this.birth[pair]), this.y.pixel(this.death[pair])];
  }

  mark(context, pair, size, color, outline) {
    const [x, y] = this.pixel_of(pair);
    context.fillStyle = color;
    context.beginPath();
    const dimension = this.dimension(pair);
    if (dimension === 0) context.arc(x, y, size, 0, 2 * Math.PI);
    else if (dimension === 1) context.rect(x - size * 0.85, y - size * 0.85, size * 1.7, size * 1.7);
    else {
      context.moveTo(x, y - size * 1.25);
      context.lineTo(x + size * 1.15, y + size * 0.85);
      context.lineTo(x - size * 1.15, y + size * 0.85);
      context.closePath();
    }
    context.fill();
    context.strokeStyle = outline ?? this.palette.paper;
    context.lineWidth = outline ? 1.6 : 0.8;
    context.stroke();
  }

  // Squares of two by two pixels, written into the canvas at once.
  draw_pixels(context, ratio) {
    const image = context.getImageData(0, 0, this.base.width, this.base.height);
    const words = new Uint32Array(image.data.buffer);
    const colors = this.palette.kinds.map(
      (hex) => 0xff000000 + parseInt(hex.slice(5) + hex.slice(3, 5) + hex.slice(1, 3), 16),
    );
    for (let i = 0; i < this.birth.length; ++i) {
      const x = Math.round(this.x.pixel(this.birth[i]) * ratio);
      const y = Math.round(this.y.pixel(this.death[i]) * ratio);
      const color = colors[this.dimension(i)];
      for (const at of [x + y * image.width, x + 1 + y * image.width]) words[at] = words[at + image.width] = color;
    }
    context.putImageData(image, 0, 0);
  }

  // The base, with what is brushed, picked, and the rectangle.
  overlay() {
    if (!this.x) return;
    const { canvas, state, complex, palette } = this;
    const context = fresh_context(canvas, this.ratio);
    context.globalAlpha = state.brush ? 0.35 : 1;
    context.drawImage(this.base, 0, 0, canvas.clientWidth, canvas.clientHeight);
    context.globalAlpha = 1;
    const brushed = state.brushed_pairs();
    for (const pair of brushed.slice(0, most_marks))
      this.mark(context, pair, 4.2, palette.kinds[this.dimension(pair)]);
    const pair = state.picked === none ? none : complex.pair_of[state.picked];
    if (pair !== none) this.mark(context, pair, 6.5, palette.highlight, palette.ink);
    const rectangle = this.brush.rectangle;
    if (!rectangle || !state.brush) return;
    context.strokeStyle = palette.accent;
    context.lineWidth = 1.5;
    context.setLineDash([5, 3]);
    context.strokeRect(
      rectangle.left,
      rectangle.top,
      rectangle.right - rectangle.left,
      rectangle.bottom - rectangle.top,
    );
    context.setLineDash([]);
  }

  brush_rectangle(rectangle) {
    if (!rectangle || !this.x) return this.actions.brush(null);
    const { x, y } = this;
    const inside = (pair) => {
      const [px, py] = [x.pixel(this.birth[pair]), y.pixel(this.death[pair])];
      return px >= rectangle.left && px <= rectangle.right && py >= rectangle.top && py <= rectangle.bottom;
    };
    this.actions.brush(inside, this);
  }

  pick(x, y) {
    if (!this.x) return;
    let [best, least] = [none, 15 * 15];
    for (let i = 0; i < this.birth.length; ++i) {
      const [dx, dy] = [this.x.pixel(this.birth[i]) - x, this.y.pixel(this.death[i]) - y];
      if (dx * dx + dy * dy < least) [best, least] = [i, dx * dx + dy * dy];
    }
    this.actions.pick_pair(best);
  }

  // Keys: N and P go through the pairs from the most persistent one on; Enter brushes the pair that is picked.
  step(event) {
    const key = event.key.toLowerCase();
    if (key !== 'n' && key !== 'p' && key !== 'enter') return;
    event.preventDefault();
    event.stopPropagation();
    const { complex, state } = this;
    if (complex.pair_count === 0) return;
    const pair = state.picked === none ? none : complex.pair_of[state.picked];
    if (key === 'enter') return pair === none ? undefined : this.actions.brush((i) => i === pair, this);
    const order = this.by_persistence();
    const at = pair === none ? (key === 'n' ? -1 : 0) : this.rank[pair];
    this.actions.pick_pair(order[(at + (key === 'n' ? 1 : order.length - 1)) % order.length]);
  }

  by_persistence() {
    if (!this.order) {
      const { persistence } = this.complex;
      this.order = Uint32Array.from(persistence.keys()).sort((a, b) => persistence[b] - persistence[a] || a - b);
      this.rank = new Uint32Array(this.order.length);
      this.order.forEach((pair, place) => (this.rank[pair] = place));
    }
    return this.order;
  }
}

function line(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}
