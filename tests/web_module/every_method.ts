// Each method of the package, as TypeScript takes it. It is compiled, and not run.
import { FlowComplex, FlowcertError, formats, load, type CheckReport, type Fraction } from "flowcert";

await load({ wasm: new Uint8Array(8), checkWasm: "https://example.org/check_module.wasm" });
const complex = new FlowComplex(new Float64Array(9), {
  name: "points.xyz",
  progress: (part, done, total) => console.log(part === "persistence", done / total),
});
const fromBytes = new FlowComplex(new ArrayBuffer(8), { format: formats[0], z: 1, atoms: ["no water"], frame: 2 });
const words: string = fromBytes.name + fromBytes.format + fromBytes.notes.map((note) => note.text).join();
const numbers: number = complex.pointCount + complex.mergedDuplicates + complex.leftOut.length + complex.counts[3];
const regular: number = complex.regularCounts["1-2"];
const index: Int8Array = complex.criticalPoints.index;
const contacts: Uint32Array = complex.stationaryPoints.contacts.subarray(complex.stationaryPoints.contactOffsets[0]);
const centers: Float64Array = complex.centers();
const { center, squaredDistance } = complex.exact(0);
const fractions: [Fraction, Fraction, Fraction, Fraction] = [...center, squaredDistance];
const product: bigint = center[0].numerator * squaredDistance.denominator;
const death: string | undefined = complex.persistence({ zero: true })[0].death?.squared_distance;
const text: string = complex.persistenceText({ plain: true });
const [cycle] = complex.cycles({ dimension: 1, longest: 3, level: "25%", witness: true });
const loops: number[][] | undefined = cycle.polygons;
const depths = (await complex.pockets({ persistence: "auto", probe: 1.4 })).pockets.map((pocket) => pocket.depth);
const cavities = (await complex.pockets({ radii: "bondi", probe: "1/3" })).cavities.length;
const pores = await complex.pores({ radii: 1.7, depth: 0.5, finite: true });
const diameters = pores.chambers.map((chamber) => chamber.diameter);
const files: Uint8Array[] = [
  complex.records({ manifolds: "all" }),
  complex.surface({ select: ["largest-gaps=3"], format: "off" }),
  await complex.page({ cells: true, pockets: "auto" }),
  await complex.page({ radii: "bondi", probe: 1.4 }),
];
const report: CheckReport = await complex.check(files[0], { name: "claim.jsonl", highestLevel: 3, indices: [1, 2] });
if (report.verdict === "fails") throw new FlowcertError(report.findings[0].sentence);
fromBytes.delete();
console.log(words, numbers, regular, index, contacts, centers, fractions, product, death, text, loops);
console.log(depths, cavities, diameters, new FlowComplex(new Uint8Array(8), "points.ply").format);

// @ts-expect-error
new FlowComplex([0, 0, 0]);
// @ts-expect-error
complex.pores({ depth: 1 });
// @ts-expect-error
complex.cycles({ dimension: 3 });
// @ts-expect-error
complex.counts = [0, 0, 0, 0];
