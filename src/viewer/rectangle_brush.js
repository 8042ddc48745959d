// A rectangle on a plot, dragged with any pointer, or moved and stretched with the arrow keys.
// `brushed(rectangle)` is called while it changes, with {left, right, top, bottom} in pixels, or null when it is gone;
// `clicked(x, y)` where a pointer went down and up in one place.

export class RectangleBrush {
  constructor(canvas, { brushed, clicked, whole_height = false }) {
    Object.assign(this, { canvas, brushed, clicked, whole_height, rectangle: null });
    canvas.addEventListener('pointerdown', (event) => this.begin(event));
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    canvas.addEventListener('pointerup', (event) => this.end(event));
    canvas.addEventListener('pointercancel', () => (this.start = null));
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  begin(event) {
    if (event.button > 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.start = this.place(event);
    this.dragged = false;
  }

  drag(event) {
    if (!this.start) return;
    const [x, y] = this.place(event);
    const [x0, y0] = this.start;
    if (!this.dragged && Math.hypot(x - x0, y - y0) < 4) return;
    this.dragged = true;
    this.set({ left: Math.min(x, x0), right: Math.max(x, x0), top: Math.min(y, y0), bottom: Math.max(y, y0) });
  }

  end(event) {
    if (this.start && !this.dragged) this.clicked(...this.place(event));
    this.start = null;
  }

  // The rectangle changes on its own terms, then everybody is told.
  set(rectangle) {
    if (rectangle && this.whole_height) Object.assign(rectangle, { top: 0, bottom: this.canvas.clientHeight });
    this.rectangle = rectangle;
    this.brushed(rectangle);
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = steps[event.key];
    if (event.key === 'Escape' && this.rectangle) this.set(null);
    else if (step) this.shift(step, event.shiftKey, event.ctrlKey ? 1 : 8);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // Arrows move the rectangle; with Shift they move its right or lower side.
  shift([x, y], stretch, size) {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const old = this.rectangle ?? { left: w / 2 - 30, right: w / 2 + 30, top: h / 2 - 30, bottom: h / 2 + 30 };
    const moved = { ...old };
    if (!stretch) {
      moved.left += x * size;
      moved.top += y * size;
    }
    moved.right = Math.max(moved.left + 2, old.right + x * size);
    moved.bottom = Math.max(moved.top + 2, old.bottom + y * size);
    this.set(moved);
  }
}
