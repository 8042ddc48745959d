// The three-dimensional scene: camera, layers, marks of what is picked, and the picture of it all.
// It draws only when something has changed. While it turns, or the slider moves, at most 100,000 triangles are drawn:
// S2 as the polygons that they span, and these thinned by persistence where they are still too many.
// At rest it draws all that `shown` says. `view` is what it draws now; `drawn()` tells the counts.

import { BufferAttribute, BufferGeometry, Group, PerspectiveCamera, Points, Scene, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { BallsAndSticks } from './balls_and_sticks.js';
import { ClippedLines } from './clipped_lines.js';
import { picked_cycle } from './cycles.js';
import { discard } from './discard.js';
import { joined } from './joined_arrays.js';
import { LineLayer } from './line_layer.js';
import { pick, pixel_of } from './picking.js';
import { PocketMark } from './pocket_mark.js';
import { pockets_at } from './pockets.js';
import { PointCloud, paint_points, point_material } from './point_cloud.js';
import { none } from './point_numbers.js';
import { PoreMark } from './pore_mark.js';
import { make_renderer } from './renderer.js';
import { SeenThrough } from './seen_through.js';
import { counts_by_kind, fitting_sets, most, shown } from './shown.js';
import { spanned_polygons } from './spanned_polygons.js';
import { sphere_mark } from './sphere_mark.js';
import { SurfaceMesh, mesh_of_positions, mesh_of_triangles } from './surface_mesh.js';

const rest_after = 160; // milliseconds
const nothing_marked = { cell: 0, surface: 0, lines: 0, pocket: 0, mouths: 0, outlines: 0, cycle: 0, loop: 0 };

export class ComplexScene {
  constructor(canvas, complex, state, palette) {
    Object.assign(this, { canvas, complex, state, palette });
    this.renderer = make_renderer(canvas, complex.s2.triangles.length > 3 * most.triangles);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 40);
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, { enableDamping: false, zoomToCursor: true, minDistance: 0.02, maxDistance: 20 });
    this.controls.addEventListener('change', () => this.move());
    this.make_layers();
    this.reset_camera();
    this.paint(palette);
    this.frames = 0;
    this.on_view = () => {};
  }

  make_layers() {
    const { complex } = this;
    this.cloud = new PointCloud(complex);
    const vertices = new BufferAttribute(complex.s2.vertices, 3);
    this.exact = new SurfaceMesh(vertices, complex.s2.triangle_offsets, complex.s2.triangles);
    this.lines = {
      s1: new LineLayer({ width: 2 }),
      u2: new LineLayer({ width: 2 }),
      infinity: new LineLayer({ width: 1.2 }),
      path: new LineLayer({ width: 4 }),
    };
    this.marks = new Group();
    this.claims = new Group();
    this.marked = nothing_marked;
    this.scene.add(this.exact.object, this.cloud.object, this.marks, this.claims);
    for (const layer of Object.values(this.lines)) this.scene.add(layer.object);
  }

  // Made when first drawn: samples as balls, with sticks.
  balls() {
    if (!this.made_balls) {
      this.made_balls = new BallsAndSticks(this.complex);
      this.made_balls.paint(this.palette);
      this.scene.add(this.made_balls.object);
    }
    return this.made_balls;
  }

  // Made when first needed: not where all triangles fit.
  polygons() {
    this.flat_parts ??= spanned_polygons(this.complex.s2);
    return this.flat_parts;
  }

  flat_mesh() {
    if (!this.flat) {
      const { offsets, triangles } = this.polygons();
      this.flat = new SurfaceMesh(this.exact.geometry.attributes.position, offsets, triangles);
      this.flat.paint(this.palette.surface);
      this.scene.add(this.flat.object);
    }
    return this.flat;
  }

  reset_camera() {
    const direction = new Vector3(0.42, 0.3, 1).normalize();
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(direction.multiplyScalar(this.home_distance()));
    this.controls.update();
    this.redraw();
  }

  // The ball around the box fits the narrower way.
  home_distance() {
    const radius = Math.max(0.4, this.bounding_radius());
    const half = (Math.PI / 180) * (this.camera.fov / 2);
    return (radius * 1.1) / Math.sin(Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect)));
  }

  bounding_radius() {
    if (this.radius_of_box === undefined) {
      const { positions, sample_count, radii, data } = this.complex;
      let most_squared = 0;
      for (let i = 0; i < 3 * sample_count; i += 3)
        most_squared = Math.max(most_squared, positions[i] ** 2 + positions[i + 1] ** 2 + positions[i + 2] ** 2);
      this.radius_of_box = Math.sqrt(most_squared) + (radii?.reduce((a, b) => Math.max(a, b), 0) ?? 0) / data.unit;
    }
    return this.radius_of_box;
  }

  resize(width, height, pixel_ratio) {
    const at_home = this.size === undefined;
    this.size = { width, height };
    this.set_pixels(width, height, pixel_ratio);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    if (at_home) this.reset_camera();
    this.redraw();
  }

  set_pixels(width, height, pixel_ratio) {
    this.renderer.setPixelRatio(pixel_ratio);
    this.renderer.setSize(width, height, false);
    this.cloud.material.uniforms.pixel_ratio.value = pixel_ratio;
  }

  paint(palette) {
    this.palette = palette;
    paint_points(this.cloud.material, palette);
    this.exact.paint(palette.surface);
    if (this.flat) this.flat.paint(palette.surface);
    this.lines.s1.paint(palette.s1);
    this.lines.u2.paint(palette.u2);
    this.lines.infinity.paint(palette.u2);
    this.made_balls?.paint(palette);
    this.lines.path.paint(palette.highlight);
    this.mark_picked();
    this.redraw();
  }

  // Something other than the camera has changed: what is shown is computed anew.
  refresh(moving = false) {
    if (moving) this.wake();
    this.view = null;
    this.redraw();
  }

  move() {
    this.wake();
    this.redraw();
  }

  // The scene is moving until nothing has happened for a while.
  wake() {
    this.moving = true;
    clearTimeout(this.rest_timer);
    this.rest_timer = setTimeout(() => {
      this.moving = false;
      this.redraw();
    }, rest_after);
  }

  redraw() {
    if (this.waiting || !this.size) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    if (!this.view) this.lay_out();
    this.choose_surface();
    this.spare_while_moving();
    this.made_balls?.set_distance(this.camera.position.distanceTo(this.controls.target));
    this.renderer.render(this.scene, this.camera);
    ++this.frames;
  }

  // Resolves when all that was given to the GPU is drawn.
  async finished() {
    const gl = this.renderer.getContext();
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.getSyncParameter(sync, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost())
      await new Promise((resolve) => setTimeout(resolve, 4));
    gl.deleteSync(sync);
  }

  lay_out() {
    const { complex, state } = this;
    this.view = shown(complex, state, () => this.polygons());
    this.cloud.show(this.view.points);
    this.lines.s1.show(this.edge_segments(this.view.edges));
    this.lay_out_lines();
    if (this.view.balls || this.made_balls) this.balls().object.visible = this.view.balls;
    this.surface_is = null;
    this.on_view(this.view);
  }

  lay_out_lines() {
    if (!this.complex.u2) return;
    this.clipped ??= new ClippedLines(this.complex.u2);
    const lines = this.lines_of(this.view.line_sets);
    const nothing = new Float32Array(0);
    for (const [layer, infinite] of [
      ['u2', false],
      ['infinity', true],
    ])
      this.lines[layer].show(this.state.layers[layer] ? this.clipped.segments(lines, infinite) : nothing);
  }

  lines_of(sets) {
    return Array.from(sets, (set) => this.complex.line_of_point[this.complex.set_point[set]]);
  }

  edge_segments(points) {
    const segments = new Float32Array(6 * points.length);
    points.forEach((point, i) => {
      this.complex
        .edge(point)
        .forEach((sample, end) =>
          segments.set(this.complex.positions.subarray(3 * sample, 3 * sample + 3), 6 * i + 3 * end),
        );
    });
    return segments;
  }

  // Exact triangles at rest, polygons where there are too many of them while the scene moves, or in a thin view.
  choose_surface() {
    const { view } = this;
    const flat = view.flat || (this.moving && view.triangles > most.triangles);
    const choice = flat ? 'flat' : 'exact';
    if (this.surface_is === choice) return;
    this.surface_is = choice;
    if (flat) {
      const sets = fitting_sets(this.complex, this.polygons().offsets, view.sets);
      this.flat_mesh().show(sets);
      this.exact.object.visible = false;
    } else if (this.exact_for !== view) {
      this.exact.show(view.sets);
      this.exact_for = view;
    }
    this.exact.object.visible = !flat && this.exact.count > 0;
    if (this.flat) this.flat.object.visible = flat && this.flat.count > 0;
    this.set_opacity();
  }

  // Very many lines and points are not drawn while the scene moves, so that it can be turned.
  spare_while_moving() {
    const fits = (count) => !this.moving || count <= most.triangles;
    for (const layer of [this.lines.s1, this.lines.u2, this.lines.infinity]) layer.object.visible = fits(layer.count);
    const count = this.cloud.shown.length;
    this.cloud.object.visible = count > 0 && fits(count);
  }

  // What can be seen through steps back behind what is picked or found. A cell, a surface U1, a pocket or a
  // cycle is inside of all else.
  set_opacity() {
    const { see_through, picked, finding } = this.state;
    const is_behind = ['cell', 'surface', 'pocket', 'cycle'].some((part) => this.marked[part] > 0);
    const opacity = is_behind ? 0.16 : !see_through ? 1 : picked !== none || finding >= 0 ? 0.16 : 0.38;
    this.exact.set_opacity(opacity);
    if (this.flat) this.flat.set_opacity(opacity);
  }

  repaint_surface() {
    this.set_opacity();
    this.redraw();
  }

  is_at_rest() {
    return !this.moving && !this.waiting && Boolean(this.view) && this.surface_is !== null;
  }

  current_view() {
    if (!this.view) this.lay_out();
    return this.view;
  }

  surface() {
    return this.surface_is === 'flat' ? this.flat : this.exact;
  }

  clear_claims() {
    discard(this.claims, null);
    this.redraw();
  }

  // What is picked: a chamber of a page with pores; a pocket alone, where it is picked as such. Otherwise the point: its
  // sphere, its contact set with radii, its pocket with mouths, the cycle of its pair if that is picked, its S2, its
  // cell S3 or its U1, its lines, and a ring around the points.
  mark_picked() {
    discard(this.marks, this.exact.geometry.attributes.position);
    this.lines.path.show(new Float32Array(0));
    this.marked = { ...nothing_marked };
    const { complex, state, palette } = this;
    const point = state.picked;
    this.mark_pores();
    if (point === none || !this.size) return;
    const center = complex.frame_position(point);
    this.mark_pockets(point);
    if (state.as_pocket && this.marked.pocket > 0) return;
    if (!complex.is_sample(point)) {
      this.marks.add(sphere_mark(center, complex.frame_radius(point), palette.accent));
      this.mark_contacts(point, center);
    }
    this.mark_cycle();
    this.mark_cell(point);
    this.mark_set(point);
    this.mark_surface(point);
    const pair = complex.pair_of[point];
    const partners = pair === none ? [] : [complex.birth[pair], complex.death[pair]].filter((p) => p !== none);
    this.mark_points([...new Set([point, ...partners])]);
  }

  mark_contacts(point, center) {
    const layer = new LineLayer({ width: 1.6, on_top: true });
    const segments = [];
    for (const sample of complex_first(this.complex.contacts(point), 500))
      segments.push(...center, ...this.complex.positions.subarray(3 * sample, 3 * sample + 3));
    layer.paint(this.palette.accent);
    layer.show(Float32Array.from(segments));
    this.marks.add(layer.object);
    this.mark_points(complex_first(this.complex.contacts(point), 500));
  }

  mark_set(point) {
    const set = this.complex.set_of_point[point];
    if (set !== none) {
      const triangles = this.complex.triangles_of_set(set);
      const mesh = mesh_of_triangles(this.exact.geometry.attributes.position, triangles);
      mesh.paint(this.palette.highlight);
      if (this.marked.cell > 0) mesh.set_opacity(0.6);
      Object.assign(mesh.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4 });
      this.marks.add(mesh.object);
    }
    const edge = this.complex.kind[point] === 1 ? this.edge_segments([point]) : null;
    this.lines.path.show(edge ?? this.line_segments(point));
  }

  // The faces around the cell S3.
  mark_cell(point) {
    const faces = this.state.layers.s3 ? this.complex.cell(point) : null;
    if (!faces) return;
    const triangles = this.complex.cells.triangles(faces.map(({ face }) => face));
    this.marked.cell = this.mark_triangles(triangles, 's3');
  }

  // The sheets of U1 with their outlines, and the lines along which it has dimension 1.
  mark_surface(point) {
    const surface = this.state.layers.u1 ? this.complex.unstable_surface(point) : null;
    if (!surface) return;
    this.marked.surface = this.mark_triangles(surface.sheets, 'u1');
    this.marked.lines = surface.lines.length / 6;
    for (const [segments, width] of [
      [surface.outlines, 1],
      [surface.lines, 3],
    ]) {
      const layer = new LineLayer({ width });
      layer.paint(this.palette.u1);
      layer.show(segments);
      this.marks.add(layer.object);
    }
  }

  // The pocket of the point, or those that it is a mouth of, with all of their mouths.
  mark_pockets(point) {
    const pockets = this.state.layers.pockets ? pockets_at(this.complex, point) : [];
    if (pockets.length === 0) return;
    this.add_seen_through(new PocketMark(this.complex, pockets, this.palette));
  }

  // The chamber with its windows, and the balls that its peak, or the picked window, touches.
  mark_pores() {
    const { pores } = this.complex;
    if (!pores?.chambers[this.state.chamber] || !this.size || !this.state.layers.pockets) return;
    this.add_seen_through(new PoreMark(pores, this.state, this.palette));
    this.mark_points(pores.witness(this.state).contact);
  }

  add_seen_through(mark) {
    Object.assign(this.marked, { pocket: mark.triangles, mouths: mark.mouths, outlines: mark.outlines });
    this.marks.add(mark.object);
  }

  // A loop with its surface, or what is around a void.
  mark_cycle() {
    const cycle = picked_cycle(this.complex, this.state);
    if (!cycle) return;
    const mark = new SeenThrough(this.palette);
    const triangles = this.complex.cycles.triangles_of(cycle);
    mark.add_walls(mesh_of_triangles(this.cycle_positions(), triangles), 'cycle');
    mark.add_outlines(this.edge_segments(cycle.edges), 5);
    Object.assign(this.marked, { cycle: mark.triangles, loop: mark.outlines });
    this.marks.add(mark.object);
  }

  cycle_positions() {
    const { position } = this.exact.geometry.attributes;
    const { vertices } = this.complex.cycles;
    if (vertices.length === 0) return position;
    this.joined_positions ??= new BufferAttribute(joined([position.array, vertices]), 3);
    return this.joined_positions;
  }

  mark_triangles(positions, color) {
    if (positions.length === 0) return 0;
    const mesh = mesh_of_positions(positions);
    mesh.paint(this.palette[color]);
    mesh.set_opacity(0.45);
    this.marks.add(mesh.object);
    return mesh.count;
  }

  // The least and the largest coordinate of the lines of U2 that are drawn.
  line_bounds() {
    const all = this.clipped.segments(this.lines_of(this.view.line_sets));
    return [all.reduce((a, b) => Math.min(a, b), 0), all.reduce((a, b) => Math.max(a, b), 0)];
  }

  // The lines of U2 of a point; none before they are decoded.
  line_segments(point) {
    const line = this.complex.u2 ? this.complex.line_of_point[point] : none;
    if (line === none) return new Float32Array(0);
    this.clipped ??= new ClippedLines(this.complex.u2);
    return this.clipped.segments([line]);
  }

  mark_points(points) {
    const positions = points.map((point) => this.complex.frame_position(point));
    this.mark_rings(positions, this.palette.accent, this.marks);
  }

  // Rings after all else, so that nothing that can be seen through is before them. Dashed ones come after others.
  mark_rings(positions, color, group, dashed = false) {
    const count = positions.length;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions.flat()), 3));
    geometry.setAttribute('kind', new BufferAttribute(new Uint8Array(count), 1));
    geometry.setAttribute('size', new BufferAttribute(new Float32Array(count).fill(dashed ? 22 : 20), 1));
    const material = point_material();
    paint_points(material, { ...this.palette, kinds: [color, color, color, color, color] });
    material.uniforms.ring.value = 1;
    material.uniforms.dashed.value = dashed ? 1 : 0;
    material.uniforms.pixel_ratio.value = this.renderer.getPixelRatio();
    Object.assign(material, { depthTest: false, transparent: true });
    const rings = new Points(geometry, material);
    rings.frustumCulled = false;
    rings.renderOrder = dashed ? 21 : 20;
    group.add(rings);
  }

  pick_at(x, y) {
    const { complex, camera, size, state } = this;
    const drawn = { points: this.cloud.shown, mesh: this.surface(), opaque: !state.see_through };
    return pick({ complex, camera, size, ...drawn, balls: this.view.balls ? this.balls() : null }, x, y);
  }

  // All points that are seen: as marks, or samples as balls.
  seen_points() {
    const { points, balls } = this.current_view();
    if (!balls || this.state.layers.samples) return points;
    const { sample_count } = this.complex;
    const others = points.filter((point) => point >= sample_count);
    const all = Uint32Array.from({ length: sample_count + others.length }, (_, i) => i);
    all.set(others, sample_count);
    return all;
  }

  pixel_of(point) {
    return pixel_of(this.camera, this.size, this.complex.frame_position(point));
  }

  // Turns to a position of the frame, from the distance given.
  look_at(position, distance, smooth) {
    const from = { target: this.controls.target.clone(), eye: this.camera.position.clone() };
    const to = new Vector3(...position);
    const way = from.eye.clone().sub(from.target).normalize().multiplyScalar(distance);
    const place = (t) => {
      const s = t * t * (3 - 2 * t);
      this.controls.target.lerpVectors(from.target, to, s);
      this.camera.position.lerpVectors(from.eye, to.clone().add(way), s);
      this.controls.update();
      this.move();
    };
    cancelAnimationFrame(this.flight);
    if (!smooth) return place(1);
    const start = performance.now();
    const step = () => {
      const t = Math.min(1, (performance.now() - start) / 450);
      place(t);
      if (t < 1) this.flight = requestAnimationFrame(step);
    };
    step();
  }

  // Turns by angles around the target, or moves nearer by a factor.
  turn(across, up, nearer = 1) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    arm.applyAxisAngle(this.camera.up, across);
    const polar = arm.angleTo(this.camera.up) - up;
    if (polar > 0.02 && polar < Math.PI - 0.02) arm.applyAxisAngle(right.applyAxisAngle(this.camera.up, across), -up);
    this.camera.position.copy(this.controls.target).add(arm.multiplyScalar(nearer));
    this.controls.update();
    this.move();
  }

  pan(x, y) {
    const scale = this.camera.position.distanceTo(this.controls.target) * 0.1;
    const shift = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0).multiplyScalar(x * scale);
    shift.add(new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1).multiplyScalar(y * scale));
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.controls.update();
    this.move();
  }

  drawn() {
    const surface = this.surface();
    return {
      points: this.view.points.length,
      by_kind: counts_by_kind(this.complex, this.view.points),
      s1: this.view.edges.length,
      s2_sets: surface.object.visible ? surface.sets.length : 0,
      triangles: surface.object.visible ? surface.count : 0,
      flat: this.surface_is === 'flat',
      u2_lines: this.view.line_sets.length,
      u2_segments: this.lines.u2.count,
      infinity_segments: this.lines.infinity.count,
      balls: this.view.balls ? this.balls().count : 0,
      sticks: this.view.balls ? this.balls().stick_count : 0,
      moving: Boolean(this.moving),
    };
  }

  // Calls copy(canvas) with the scene in it, drawn now and at twice the pixels, and returns what that returns.
  picture(copy) {
    const { width, height } = this.size;
    const ratio = this.renderer.getPixelRatio();
    this.moving = false;
    this.set_pixels(width, height, 2 * ratio);
    this.draw();
    const result = copy(this.canvas);
    this.set_pixels(width, height, ratio);
    this.draw();
    return result;
  }
}

const complex_first = (items, count) => Array.from(items.subarray(0, count));
