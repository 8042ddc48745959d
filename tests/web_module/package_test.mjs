// The npm package, installed from its .tgz in an empty folder, offline: what each method of index.d.ts gives is what
// the program says, invalid input gives the program's sentences, and pages have nothing of the modules in them.
//
// FLOWCERT is the program, FLOWCERT_TGZ the package, and FLOWCERT_TSC the compiler tsc of TypeScript. Without one of
// the first two all tests are skipped, without the third the test of types.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../..");
const program = process.env.FLOWCERT;
const missing = !program ? "FLOWCERT, the program" : !process.env.FLOWCERT_TGZ ? "FLOWCERT_TGZ, the package" : null;
const skip = missing ? `there is no ${missing}` : false;

let folder, installed, flowcert;

before(async () => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), "flowcert-package-"));
  writeFileSync(join(folder, "package.json"), `{"type":"module"}`);
  const words = ["install", "--offline", "--no-audit", "--no-fund", process.env.FLOWCERT_TGZ];
  execFileSync("npm", words, { cwd: folder, stdio: "pipe" });
  installed = join(folder, "node_modules/flowcert");
  flowcert = await import(pathToFileURL(join(installed, "index.js")));
});
after(() => folder && rmSync(folder, { recursive: true }));

const cube = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [k & 1, (k >> 1) & 1, k >> 2]);
const pyramid = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 3], [1.2, 0.3, 1.1], [1, 0, 2]];
const octahedron = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
const text = (rows) => rows.map((row) => row.join(" ") + "\n").join("");
const ply = (rows) => {
  const head = "ply\nformat binary_little_endian 1.0\nelement vertex " + rows.length;
  const properties = ["x", "y", "z"].map((axis) => `\nproperty double ${axis}`).join("");
  return Buffer.concat([
    Buffer.from(`${head}${properties}\nend_header\n`),
    Buffer.from(new Float64Array(rows.flat()).buffer),
  ]);
};
const input = (name) => readFileSync(join(root, "tests/inputs", name));
// Each is computed once, and is compared by several tests.
const files = {
  "cube.xyz": Buffer.from(text(cube)),
  "pyramid.xyz.gz": gzipSync(text(pyramid)),
  "octahedron.ply": ply(octahedron),
  "twice.csv": Buffer.from("x,y,z\n0,0,0\n0,0,0\n3,0,0\n0,4,0\n"),
  "cage.xyz": input("cage.xyz"),
  "ligand.pdb": input("ligand_and_water.pdb"),
  "empty.csv": Buffer.from("x,y,z\n"),
};

const paths = {};
function path(name, bytes = files[name]) {
  paths[name] ??= join(folder, name);
  writeFileSync(paths[name], bytes);
  return name;
}
function run(...words) {
  const done = spawnSync(program, words.map(String), { cwd: folder, maxBuffer: 1 << 30 });
  return { status: done.status, out: done.stdout, said: done.stderr.toString() };
}
function printed(...words) {
  const { status, out, said } = run(...words);
  assert.ok(status === 0 || status === 1, said);
  return out;
}
// Without what made it.
const madeBy = ["version", "commit", "kernel", "compiler", "cgal"];
function plain(object) {
  const copy = { ...object };
  for (const key of madeBy) delete copy[key];
  return copy;
}
const json = (bytes) => plain(JSON.parse(bytes));
const shortened = (bytes) =>
  Buffer.from(bytes).toString("latin1").replace(/"version":.*?"cgal":"[^"]*"|(by|#) flowcert .*?CGAL [0-9.]*\)/g, "");

async function made(name, options = {}) {
  await flowcert.load();
  return new flowcert.FlowComplex(files[name], { name, ...options });
}
async function withEach(names, work) {
  for (const name of names) {
    path(name);
    const complex = await made(name);
    try {
      await work(complex, name);
    } finally {
      complex.delete();
    }
  }
}
const all = Object.keys(files);

test("the example of the README prints what it says", { skip }, () => {
  const readme = readFileSync(join(installed, "README.md"), "utf8");
  const [example, output] = ["package", "package output"].map(
    (name) => readme.split(`<!-- example: ${name} -->`)[1].split("```")[1].replace(/^\w*\n/, ""),
  );
  writeFileSync(join(folder, "example.mjs"), example);
  assert.equal(execFileSync("node", ["example.mjs"], { cwd: folder, encoding: "utf8" }), output);
});

test("the package has what is declared, and nothing else", { skip }, async () => {
  const declared = readFileSync(join(installed, "index.d.ts"), "utf8");
  const body = declared.split("export class FlowComplex {")[1];
  const members = new Set([...body.matchAll(/^  (?:readonly )?(\[?[\w.]+\]?)[(:]/gm)].map((match) => match[1]));
  const complex = await made("cube.xyz");
  const own = [...Object.keys(complex), ...Object.getOwnPropertyNames(flowcert.FlowComplex.prototype)];
  assert.deepEqual(new Set(own), members);
  assert.match(readFileSync(join(installed, "disposable.d.ts"), "utf8"), /^ +\[Symbol\.dispose\]\(\): void;$/m);
  assert.equal(typeof complex[Symbol.dispose ?? Symbol.for("Symbol.dispose")], "function");
  const exported = [...declared.matchAll(/^export (?:class|function|const) (\w+)/gm)].map((match) => match[1]);
  assert.deepEqual(Object.keys(flowcert).sort(), exported.sort());
  complex.delete();
});

test("records are those of compute -o", { skip }, async () => {
  await withEach(all, (complex, name) => {
    for (const manifolds of [undefined, "u2", "s2", "u2,s2", "all"]) {
      printed("compute", name, "-o", "records", ...(manifolds ? ["--manifolds", manifolds] : []));
      const [header, ...lines] = readFileSync(join(folder, "records"), "utf8").split("\n");
      const [ourHeader, ...ours] = Buffer.from(complex.records({ manifolds })).toString().split("\n");
      assert.deepEqual(json(ourHeader), json(header));
      assert.deepEqual(ours, lines, `${name} ${manifolds}`);
    }
  });
  const complex = await made("pyramid.xyz.gz");
  printed("compute", "pyramid.xyz.gz", "-o", "records", "--manifolds", "all", "--polylines", "--skeletons");
  const records = complex.records({ manifolds: "all", polylines: true, skeletons: true });
  assert.equal(shortened(records), shortened(readFileSync(join(folder, "records"))));
  complex.delete();
});

test("counts, columns, centres and exact numbers are those of the records", { skip }, async () => {
  await withEach(all, (complex, name) => {
    const lines = Buffer.from(complex.records()).toString().trimEnd().split("\n");
    const [header, ...records] = lines.map((line) => JSON.parse(line));
    assert.deepEqual(complex.counts, header.critical);
    assert.deepEqual(complex.regularCounts, header.regular_stationary);
    assert.equal(complex.pointCount, header.points);
    assert.equal(complex.mergedDuplicates, header.merged_duplicates);
    const { length, index, kind, center, squaredDistance, contactOffsets, contacts } = complex.stationaryPoints;
    assert.equal(length, records.length);
    assert.deepEqual(complex.centers(), center);
    records.forEach((record, i) => {
      assert.equal(index[i], typeof record.index === "number" ? record.index : -1);
      assert.deepEqual([...kind.subarray(2 * i, 2 * i + 2)], [record.index, record.index].flat().slice(0, 2));
      assert.deepEqual([...center.subarray(3 * i, 3 * i + 3)], record.center_double);
      assert.equal(squaredDistance[i], record.squared_distance_double);
      assert.deepEqual([...contacts.subarray(contactOffsets[i], contactOffsets[i + 1])], record.contact);
      const exact = complex.exact(i);
      assert.deepEqual(exact.center.map((number) => number.text), record.center);
      assert.equal(exact.squaredDistance.text, record.squared_distance);
    });
    const critical = complex.criticalPoints;
    assert.equal(critical.length, complex.counts.reduce((a, b) => a + b));
    assert.deepEqual(critical.index, index.subarray(0, critical.length));
    assert.equal(critical.contactOffsets.length, critical.length + 1);
    assert.equal(critical.center.length, 3 * critical.length);
    assert.throws(() => complex.exact(length), new RegExp(`no stationary point ${length}; there are ${length}$`), name);
    assert.throws(() => complex.exact(-1), flowcert.FlowcertError);
    assert.throws(() => complex.exact(0.5), flowcert.FlowcertError);
  });
});

test("fractions are pairs of BigInt", { skip }, async () => {
  const complex = new flowcert.FlowComplex(new Float64Array([0, 0, 0, -1, 0.5, 0]));
  const { center, squaredDistance } = complex.exact(2);
  assert.deepEqual(
    [...center, squaredDistance].map(({ text, numerator, denominator }) => [text, numerator, denominator]),
    [["-1/2", -1n, 2n], ["1/4", 1n, 4n], ["0", 0n, 1n], ["5/16", 5n, 16n]],
  );
  complex.delete();
});

test("pairs are those of persistence", { skip }, async () => {
  await withEach(all, (complex, name) => {
    assert.deepEqual(complex.persistence(), json(printed("persistence", name, "--json")).pairs);
    const zero = json(printed("persistence", name, "--json", "--zero")).pairs;
    assert.deepEqual(complex.persistence({ zero: true }), zero);
    for (const [options, words] of [[{}, []], [{ plain: true, zero: true }, ["--plain", "--zero"]]]) {
      const file = printed("persistence", name, "-o", "-", ...words);
      assert.equal(shortened(Buffer.from(complex.persistenceText(options))), shortened(file));
    }
  });
});

test("cycles are those of cycles --json", { skip }, async () => {
  await withEach(["cube.xyz", "pyramid.xyz.gz", "octahedron.ply", "cage.xyz"], (complex, name) => {
    for (const options of [
      {},
      { dimension: 0, longest: 3 },
      { dimension: 2 },
      { persistence: "auto", level: "birth", witness: true },
      { longest: 1, level: "99.5%" },
    ]) {
      const words = Object.entries(options).flatMap(([key, value]) => [`--${key}`, ...(value === true ? [] : [value])]);
      assert.deepEqual(complex.cycles(options), json(printed("cycles", name, "--json", ...words)).cycles);
    }
    const [{ birth, death }] = complex.cycles({ dimension: 0, longest: 1 });
    const pair = `${birth.contact}/${death.contact}`;
    const words = ["cycles", name, "--json", "--dimension", "0", "--pair", pair];
    assert.deepEqual(complex.cycles({ dimension: 0, pair }), json(printed(...words)).cycles);
  });
});

test("pockets, cavities and pores are those of the program", { skip }, async () => {
  await withEach(all, async (complex, name) => {
    assert.deepEqual(plain(await complex.pockets()), json(printed("pockets", name, "--json")));
    const words = ["--persistence", "0", "--probe", "0.9", "--volumes", "exact"];
    const options = { persistence: 0, probe: 0.9, volumes: "exact" };
    assert.deepEqual(plain(await complex.pockets(options)), json(printed("pockets", name, "--json", ...words)));
    if (name !== "cage.xyz" && name !== "octahedron.ply") return;
    const radii = name === "cage.xyz" ? "bondi,H=1.1" : "1/3";
    const cavities = printed("pockets", name, "--radii", radii, "--probe", "1/7", "--json");
    assert.deepEqual(plain(await complex.pockets({ radii, probe: "1/7" })), json(cavities));
    const pores = printed("pores", name, "--radii", radii, "--depth", "0.5", "--probe", "1.4", "--json");
    assert.deepEqual(plain(await complex.pores({ radii, depth: 0.5, probe: 1.4 })), json(pores));
    assert.deepEqual(plain(await complex.pores({ radii })), json(printed("pores", name, "--radii", radii, "--json")));
  });
});

test("surfaces are those of surface -o", { skip }, async () => {
  await withEach(["cube.xyz", "pyramid.xyz.gz", "cage.xyz"], (complex, name) => {
    for (const [select, format] of [
      [undefined, "ply"],
      ["largest-gaps=2", "off"],
      [["index2-radius<q0.5", "persistence>0"], undefined],
    ]) {
      const file = `surface.${format ?? "ply"}`;
      printed("surface", name, "-o", file, ...[select ?? []].flat().flatMap((each) => ["--select", each]));
      assert.equal(shortened(complex.surface({ select, format })), shortened(readFileSync(join(folder, file))));
    }
  });
});

// ---- Pages ----

// Whether both have the same `size` bytes in a row somewhere. Any such row has one of the module's pieces of half that.
function sharesBytes(page, module, size) {
  const half = size / 2;
  const pieces = new Map();
  for (let k = 0; k + half <= module.length; k += half) pieces.set(module.toString("latin1", k, k + half), k);
  const text = page.toString("latin1");
  for (let at = 0; at + half <= text.length; ++at) {
    const place = pieces.get(text.slice(at, at + half));
    if (place === undefined) continue;
    let [first, last] = [0, half];
    while (first > -half && page[at + first - 1] === module[place + first - 1] && at + first > 0) --first;
    while (last < size && at + last < page.length && page[at + last] === module[place + last]) ++last;
    if (last - first >= size) return true;
  }
  return false;
}

test("pages are those of view, and nothing of a module is in them", { skip }, async () => {
  const template = readFileSync(join(root, "src/viewer/page.html"), "utf8").split('id="flowcert-data">null</script>');
  assert.equal(template.length, 2);
  const modules = ["flowcert_module", "radii_module", "check_module"].flatMap((name) => [`${name}.wasm`, `${name}.js`]);
  const ours = [...modules, "index.js"].map((name) => readFileSync(join(installed, name)));
  const with64 = Buffer.concat([Buffer.from("???"), ours[0].subarray(5000, 5064), Buffer.from("???")]);
  assert.ok(sharesBytes(with64, ours[0], 64));
  assert.ok(!sharesBytes(with64.subarray(4), ours[0], 64));
  for (const module of ours) assert.ok(!sharesBytes(Buffer.from(template.join("")), module, 64));
  await withEach(all, async (complex, name) => {
    for (const [options, words] of [
      [{}, []],
      [{ cells: true, pockets: "auto", mostCells: 3 }, ["--cells", "--pockets", "auto", "--most-cells", "3"]],
      ...(name === "cage.xyz" ? [[{ radii: "bondi", depth: 0.5 }, ["--radii", "bondi", "--depth", "0.5"]]] : []),
    ]) {
      const page = Buffer.from(await complex.page(options));
      printed("view", name, "-o", "page.html", ...words);
      assert.equal(shortened(page), shortened(readFileSync(join(folder, "page.html"))), `${name} ${words}`);
      const html = page.toString();
      const [before, behind] = template;
      assert.ok(html.startsWith(before) && html.endsWith(behind));
      const data = Buffer.from(html.slice(before.length, html.length - behind.length));
      for (const module of ours) assert.ok(!sharesBytes(data, module, 64), name);
    }
  });
});

// ---- Judging ----

test("check says what check --json says", { skip }, async () => {
  path("pyramid.xyz.gz");
  const complex = await made("pyramid.xyz.gz");
  const records = Buffer.from(complex.records({ manifolds: "all" })).toString();
  const wrong = records.replace('"contact":[1,2]', '"contact":[1,3]').replace('distance":"1"', 'distance":"2"');
  const claims = {
    "right.jsonl": records,
    "wrong.jsonl.gz": gzipSync(wrong),
    "right.pers": complex.persistenceText(),
    "wrong.pers": "0 0 1\n0 0 2\n",
    "pairs.json": printed("persistence", "pyramid.xyz.gz", "--json"),
    "cycles.json": printed("cycles", "pyramid.xyz.gz", "--json"),
    "pockets.json": printed("pockets", "pyramid.xyz.gz", "--json"),
    "critical.csv": "index,contact\n3,0 1 2\n",
  };
  for (const [name, claim] of Object.entries(claims)) {
    path(name, claim);
    const { status, out, said } = run("check", "pyramid.xyz.gz", name, "--json");
    if (status > 1) {
      await assert.rejects(complex.check(claim, { name }), { name: "FlowcertError", message: said.trim().slice(10) });
      continue;
    }
    assert.deepEqual(plain(await complex.check(claim, { name })), json(out), name);
  }
  const chosen = ["--highest-level", "3", "--indices", "1,2", "--tolerance", "1e-7"];
  const words = ["check", "pyramid.xyz.gz", "right.jsonl", "--json", ...chosen];
  const options = { name: "right.jsonl", highestLevel: 3, indices: [1, 2], tolerance: 1e-7 };
  assert.deepEqual(plain(await complex.check(records, options)), json(printed(...words)));
  complex.delete();

  const array = new flowcert.FlowComplex(new Float64Array(pyramid.flat()));
  assert.deepEqual(plain(await array.check(records, options)), json(printed(...words)));
  array.delete();

  path("cage.xyz");
  const cage = await made("cage.xyz");
  path("pores.txt", "cavity 5.4\nwindow 3.63\n");
  const judged = json(printed("check", "cage.xyz", "pores.txt", "--json", "--radii", "bondi"));
  assert.deepEqual(plain(await cage.check("cavity 5.4\nwindow 3.63\n", { radii: "bondi" })), judged);
  cage.delete();
});

test("other modules are loaded when they are asked for", { skip }, async () => {
  const copy = join(folder, "copy");
  cpSync(installed, copy, { recursive: true });
  const files = ["check", "radii"].flatMap((part) => [`${part}_module.js`, `${part}_module.wasm`]);
  for (const file of files) rmSync(join(copy, file));
  const first = await import(pathToFileURL(join(copy, "index.js")));
  await first.load();
  const complex = new first.FlowComplex(new Float64Array([0, 0, 0, 2, 0, 0]));
  assert.deepEqual(complex.counts, [2, 1, 0, 0]);
  await assert.rejects(complex.check(complex.records()), { code: "ERR_MODULE_NOT_FOUND" });
  await assert.rejects(complex.pores({ radii: 1 }), { code: "ERR_MODULE_NOT_FOUND" });
  assert.equal((await complex.pockets()).pockets.length, 0);
  complex.delete();
});

// ---- What goes wrong ----

test("invalid input gives the program's sentences", { skip }, async () => {
  await flowcert.load();
  const refused = (work, ...words) => {
    const { status, said } = run(...words);
    assert.equal(status, 2);
    const sentence = said.split("\n").find((line) => line.startsWith("flowcert: ")).slice("flowcert: ".length);
    assert.throws(work, { name: "FlowcertError", message: sentence });
  };
  for (const [name, bytes, options, ...words] of [
    ["letters.xyz", "1 2 x\n"],
    ["nan.xyz", "0 0 0\n1 nan 0\n"],
    ["blank.xyz", " \n"],
    ["stl.stl", "solid x\n  facet normal 0 0 1\n"],
    ["cut.ply", ply(cube).subarray(0, 200)],
    ["cut.xyz.gz", gzipSync(text(cube)).subarray(0, 30)],
    ["far.xyz", "1e999 0 0\n"],
    ["bell\x07.xyz", "1 2\n"],
    ["cube.xyz", files["cube.xyz"], { format: "foo" }, "--format", "foo"],
    ["cube.xyz", files["cube.xyz"], { atoms: ["protein"] }, "--atoms", "protein"],
    ["cube.xyz", files["cube.xyz"], { columns: "1,2,9" }, "--columns", "1,2,9"],
    ["ligand.pdb", files["ligand.pdb"], { chains: ["Z"] }, "--chains", "Z"],
    ["ligand.pdb", files["ligand.pdb"], { atoms: ["no water", "bread"] }, "--atoms", "no water,bread"],
  ]) {
    path(name, Buffer.from(bytes));
    refused(() => new flowcert.FlowComplex(Buffer.from(bytes), { name, ...options }), "compute", name, ...words);
  }
  path("cube.xyz");
  const complex = await made("cube.xyz");
  refused(() => complex.cycles({ level: "200%" }), "cycles", "cube.xyz", "--level", "200%");
  refused(() => complex.cycles({ pair: "1/2" }), "cycles", "cube.xyz", "--pair", "1/2");
  refused(() => complex.surface({ select: "foo<1" }), "surface", "cube.xyz", "-o", "s.ply", "--select", "foo<1");
  for (const [ask, ...words] of [
    [() => complex.pockets({ persistence: -1 }), "pockets", "--persistence", "-1"],
    [() => complex.pockets({ probe: "x" }), "pockets", "--probe", "x"],
    [() => complex.pores({ radii: "bondi" }), "pores", "--radii", "bondi"],
    [() => complex.pores({ radii: 0 }), "pores", "--radii", "0"],
    [() => complex.page({ pockets: "foo" }), "view", "-o", "v.html", "--pockets", "foo"],
  ]) {
    const error = await ask().catch((thrown) => thrown);
    const fail = () => {
      throw error;
    };
    refused(fail, words[0], "cube.xyz", ...words.slice(1));
  }
  for (const [manifolds, flag] of [["s2", "polylines"], ["u2", "skeletons"]]) {
    const words = ["compute", "cube.xyz", "-o", "records", "--manifolds", manifolds, `--${flag}`];
    refused(() => complex.records({ manifolds, [flag]: true }), ...words);
  }
  const message = "format: 'OFF' is not one of 'ply', 'off'";
  assert.throws(() => complex.surface({ format: "OFF" }), { name: "FlowcertError", message });
  assert.throws(() => complex.records({ manifolds: "s1" }), { message: /^manifolds: 's1' is not one of 'u2', / });
  await assert.rejects(complex.pockets({ volumes: "shares" }), { message: /^volumes: 'shares' is not one of / });
  await assert.rejects(complex.check("", { format: "csv" }), { message: /^format: 'csv' is not one of / });
  await assert.rejects(complex.check("cavity 1\n"), { message: /^--radii is needed: / });
  await assert.rejects(complex.check("{}", { name: "c.json" }), flowcert.FlowcertError);
  complex.delete();
});

test("an array is points as well, and has to be one of rows", { skip }, async () => {
  const array = new flowcert.FlowComplex(new Float64Array(pyramid.flat()));
  const file = await made("pyramid.xyz.gz");
  assert.deepEqual(array.records(), file.records());
  assert.equal(array.name, "points");
  array.delete();
  file.delete();
  assert.throws(() => new flowcert.FlowComplex(new Float64Array(4)), { message: /^4 numbers are no rows/ });
  assert.throws(() => new flowcert.FlowComplex(new Float64Array([0, NaN, 0])), flowcert.FlowcertError);
  assert.throws(() => new flowcert.FlowComplex([0, 0, 0]), TypeError);
  const none = new flowcert.FlowComplex(new Float64Array(0));
  assert.deepEqual(none.counts, [0, 0, 0, 0]);
  none.delete();
  const buffer = new Uint8Array(files["cube.xyz"]).buffer;
  const cubes = new flowcert.FlowComplex(buffer, "cube.xyz");
  assert.deepEqual([cubes.name, cubes.format], ["cube.xyz", "table"]);
  cubes.delete();
});

test("formats are those that are read", { skip }, async () => {
  path("cube.xyz");
  const names = run("compute", "cube.xyz", "--format", "foo").said.split("there are ")[1].trim().split(", ");
  assert.deepEqual(flowcert.formats, names);
});

test("notes and rows that are left out are told", { skip }, async () => {
  const complex = new flowcert.FlowComplex(Buffer.from("0 0 0\nnan 0 0\n2 0 0\n"), { skipInvalid: true });
  assert.deepEqual(complex.leftOut, [1]);
  complex.delete();
  const cage = await made("cage.xyz");
  assert.match(cage.notes[0].text, /84 hydrogens/);
  assert.ok(cage.hasAtoms);
  cage.delete();
});

test("progress is told, and can end the work", { skip }, async () => {
  const told = [];
  const progress = (part, done, total) => told.push([part, done, total]);
  const complex = await made("cage.xyz", { progress });
  await complex.page();
  const parts = new Set(told.map(([part]) => part));
  const some = ["Delaunay triangulation", "critical points", "persistence", "page"];
  for (const part of some) assert.ok(parts.has(part), part);
  assert.ok(told.every(([, done, total]) => done <= total));
  const expected = complex.records();
  complex.delete();

  let left = 2;
  const stop = new Error("enough");
  const stopped = await made("cage.xyz", {
    progress: () => {
      if (left-- === 0) throw stop;
    },
  });
  assert.throws(() => stopped.persistence(), (error) => error === stop);
  assert.deepEqual(stopped.records(), expected);
  stopped.delete();
});

test("a complex that is deleted answers no more", { skip }, async () => {
  const complex = await made("cube.xyz");
  complex[Symbol.dispose ?? Symbol.for("Symbol.dispose")]();
  complex.delete();
  assert.throws(() => complex.counts, /deleted/);
  await assert.rejects(complex.check("{}"), /deleted/);
});

test("load comes first, and takes bytes, an address or a compiled module", { skip }, async () => {
  const copy = join(folder, "moved");
  cpSync(installed, copy, { recursive: true });
  const second = await import(pathToFileURL(join(copy, "index.js")));
  assert.throws(() => new second.FlowComplex(new Float64Array(3)), /load\(\)/);
  const wasm = join(copy, "elsewhere.wasm"), checkWasm = readFileSync(join(copy, "check_module.wasm"));
  renameSync(join(copy, "flowcert_module.wasm"), wasm);
  rmSync(join(copy, "check_module.wasm"));
  await assert.rejects(second.load());
  // A module that imports b of a, which nobody gives it.
  const foreign = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 2, 7, 1, 1, 97, 1, 98, 0, 0];
  await assert.rejects(second.load({ wasm: new WebAssembly.Module(new Uint8Array(foreign)) }));
  await second.load({ wasm: readFileSync(wasm), checkWasm });
  await Promise.all([second.load(), second.load()]);
  const complex = new second.FlowComplex(new Float64Array(3));
  assert.equal((await complex.check(complex.records())).verdict, "conforms");
  complex.delete();
  for (const given of [pathToFileURL(wasm).href, new WebAssembly.Module(readFileSync(wasm))]) {
    const other = await import(`${pathToFileURL(join(copy, "index.js"))}?${typeof given}`);
    await other.load({ wasm: given });
    const point = new other.FlowComplex(new Float64Array(3));
    assert.deepEqual(point.counts, [1, 0, 0, 0]);
    point.delete();
  }
});

test("the version is the project's", { skip }, () => {
  const version = readFileSync(join(root, "CMakeLists.txt"), "utf8").match(/project\(flowcert VERSION ([0-9.]+)/)[1];
  assert.equal(JSON.parse(readFileSync(join(installed, "package.json"))).version, version);
});

const noTsc = process.env.FLOWCERT_TSC ? false : "there is no FLOWCERT_TSC, tsc of TypeScript";
test("tsc takes the types", { skip: skip || noTsc }, () => {
  cpSync(join(here, "every_method.ts"), join(folder, "every_method.ts"));
  const words = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "every_method.ts"];
  const done = spawnSync(process.env.FLOWCERT_TSC, words, { cwd: folder, encoding: "utf8" });
  assert.equal(done.status, 0, done.stdout);
});
