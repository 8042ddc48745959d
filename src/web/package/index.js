// What index.d.ts declares, over the modules of WebAssembly.
//
// Guarantees: an input that cannot be used is a FlowcertError with the program's sentence. Whatever else is thrown, as
// by a function `progress`, comes through as it is. The modules for radii and for check() are neither asked for nor
// loaded before a method needs them.
import createFlowcert from "./flowcert_module.js";

let core, loading;
const later = {
  check: { glue: () => import("./check_module.js") },
  radii: { glue: () => import("./radii_module.js") },
};

export class FlowcertError extends Error {
  name = "FlowcertError";
}

export const formats = Object.freeze([
  "table", "pts", "chemical", "off", "ply", "obj", "pcd", "npy", "pdb", "pqr", "cif",
]);

// What Emscripten's own functions take. They never hear of a compiled module that cannot be made to run: fail() does.
function place(wasm, fail) {
  if (wasm === undefined) return {};
  if (typeof wasm === "string") return { locateFile: () => wasm };
  if (!(wasm instanceof WebAssembly.Module)) return { wasmBinary: wasm };
  const instantiateWasm = (imports, ready) => {
    WebAssembly.instantiate(wasm, imports).then((instance) => ready(instance, wasm)).catch(fail);
    return {};
  };
  return { instantiateWasm };
}

function made(create, wasm) {
  return new Promise((resolve, reject) => create(place(wasm, reject)).then(resolve, reject));
}

export async function load(options = {}) {
  later.check.wasm = options.checkWasm ?? later.check.wasm;
  later.radii.wasm = options.radiiWasm ?? later.radii.wasm;
  loading ??= made(createFlowcert, options.wasm);
  try {
    core = await loading;
  } catch (error) {
    loading = undefined; // the next call tries again
    throw error;
  }
}

async function moduleOf(part) {
  part.loading ??= part.glue().then((module) => made(module.default, part.wasm));
  try {
    return await part.loading;
  } catch (error) {
    part.loading = undefined;
    throw error;
  }
}

// The modules throw sentences.
function asked(work) {
  try {
    return work();
  } catch (error) {
    throw typeof error === "string" ? new FlowcertError(error) : error;
  }
}

function bytesOf(content, what) {
  if (typeof content === "string") return new TextEncoder().encode(content);
  if (content instanceof ArrayBuffer) return new Uint8Array(content);
  if (content instanceof Uint8Array) return content;
  throw new TypeError(`${what} must be bytes, as a Uint8Array or an ArrayBuffer`);
}

function fractionOf(text) {
  const [numerator, denominator = "1"] = text.split("/");
  return Object.freeze({ text, numerator: BigInt(numerator), denominator: BigInt(denominator) });
}

const hasRadii = (options) => options?.radii !== undefined && options.radii !== null;

export class FlowComplex {
  #core;
  #read;
  #kept = {};

  constructor(points, options = {}) {
    if (core === undefined) throw new Error("load() of flowcert has to be waited for before a FlowComplex is made");
    const isArray = points instanceof Float64Array;
    const content = isArray ? points : bytesOf(points, "points that are no Float64Array");
    const said = typeof options === "string" ? { name: options } : options;
    // An array has no columns, chains or frames.
    const { name, unlimited, progress } = said;
    this.#read = isArray ? { name, unlimited, progress } : { ...said };
    this.#core = asked(() => new core.Complex(content, this.#read));
    Object.assign(this, JSON.parse(this.#ask("facts")));
  }

  #ask(method, options = {}) {
    if (this.#core === undefined) throw new Error("this FlowComplex was deleted");
    return asked(() => this.#core[method](options));
  }

  get #counts() {
    return (this.#kept.counts ??= JSON.parse(this.#ask("counts")));
  }

  get counts() {
    return [...this.#counts.critical];
  }

  get regularCounts() {
    return { ...this.#counts.regular_stationary };
  }

  get stationaryPoints() {
    if (this.#kept.points === undefined) {
      const columns = { center: this.centers(), ...this.#ask("stationaryPoints") };
      this.#kept.points = Object.freeze({ length: columns.index.length, ...columns });
    }
    return this.#kept.points;
  }

  get criticalPoints() {
    const { index, kind, center, squaredDistance, contactOffsets, contacts } = this.stationaryPoints;
    const length = this.#counts.critical.reduce((sum, count) => sum + count);
    return Object.freeze({
      length,
      index: index.subarray(0, length),
      kind: kind.subarray(0, 2 * length),
      center: center.subarray(0, 3 * length),
      squaredDistance: squaredDistance.subarray(0, length),
      contactOffsets: contactOffsets.subarray(0, length + 1),
      contacts: contacts.subarray(0, contactOffsets[length]),
    });
  }

  centers() {
    return this.#ask("centers");
  }

  exact(i) {
    const [x, y, z, squaredDistance] = JSON.parse(this.#ask("exact", { i })).map(fractionOf);
    return { center: [x, y, z], squaredDistance };
  }

  persistence(options) {
    const pairs = [];
    this.#ask("persistence", { ...options, take: (text) => pairs.push(...JSON.parse(text)) });
    return pairs;
  }

  persistenceText(options) {
    return this.#ask("persistenceText", options);
  }

  cycles(options) {
    return JSON.parse(this.#ask("cycles", options)).cycles;
  }

  // Atoms with radii have no flow complex: they are read anew, with their radii.
  async #askRadii(method, options) {
    const content = this.#ask("content");
    const module = await moduleOf(later.radii);
    return asked(() => module[method](content, this.#read, options));
  }

  async pockets(options) {
    return JSON.parse(await (hasRadii(options) ? this.#askRadii("pockets", options) : this.#ask("pockets", options)));
  }

  async pores(options = {}) {
    return JSON.parse(await this.#askRadii("pores", options));
  }

  records(options) {
    return this.#ask("records", options);
  }

  surface(options) {
    return this.#ask("surface", options);
  }

  async page(options) {
    const data = await (hasRadii(options) ? this.#askRadii("page", options) : this.#ask("page", options));
    const { before, behind } = await import("./viewer_page.js");
    return new Uint8Array(await new Blob([before, data, behind]).arrayBuffer());
  }

  async check(claim, options = {}) {
    const claimed = bytesOf(claim, "a claim that is no text");
    const content = this.#ask("content");
    const { check } = await moduleOf(later.check);
    return JSON.parse(asked(() => check(content, this.#read, claimed, options)));
  }

  delete() {
    this.#core?.delete();
    this.#core = undefined;
    this.#kept = {};
  }

  [Symbol.dispose ?? Symbol.for("Symbol.dispose")]() {
    this.delete();
  }
}
