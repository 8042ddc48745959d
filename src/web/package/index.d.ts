// Flowcert in JavaScript: the flow complex of points in space, exactly (README.md).
//
// Guarantees: nothing is rounded but what is called a double, and that is the nearest one. Names of keys in objects
// are those of the program's JSON (spec/formats/ of the project), and its own objects come as they are. Points are
// named by their rows, and stationary points by their places in `stationaryPoints`, from 0.

/** An input that cannot be used. `message` is the line that the program `flowcert` says of it, with file and line. */
export class FlowcertError extends Error {
  readonly name: "FlowcertError";
}

/** The files of WebAssembly, if not those beside the package's own: an address, bytes, or a WebAssembly.Module. */
export interface LoadOptions {
  wasm?: string | object;
  checkWasm?: string | object;
  radiiWasm?: string | object;
}

/** Loads the module, once. It has to be there before the first FlowComplex is made. */
export function load(options?: LoadOptions): Promise<void>;

/** The formats of files of points, as `format` takes them. Each is also read as `.gz`. */
export const formats: readonly string[];

/** What is said of points, as the program's options of the same names. */
export interface FlowComplexOptions {
  /** Of the file, for messages and pages; "points" without it. */
  name?: string;
  /** One of `formats`. Without it, the content says what it is. */
  format?: string;
  /** Of a table: which columns are x, y, z, by number from 1 or by name: "2,3,4". */
  columns?: string;
  /** Of a table of two columns: the third coordinate. */
  z?: number;
  /** Of a molecule: words for its atoms, as "protein" or "no water"; its chains; its models: "all", or "1,2". */
  atoms?: string[];
  chains?: string[];
  models?: string;
  /** Of chemical XYZ: which frame, from 1. */
  frame?: number;
  /** Leaves out rows with a coordinate that is not a finite number. */
  skipInvalid?: boolean;
  /** Also reads what grows a hundred times when it is unpacked, and computes more than a hundred cells a point. */
  unlimited?: boolean;
  /**
   * Called now and then while something is computed, with its name: "Delaunay triangulation", "critical points",
   * "unstable manifolds", "stable manifolds", "chain complex", "links of saddles", "persistence", "limits of all
   * directions", "volumes", "unstable sets of dimension 2", "merge trees", "page", "records", "surface", "cycles",
   * "checking level 1". What it throws ends the work, and comes out of the method.
   */
  progress?: (part: string, done: number, total: number) => void;
}

/** A number as it is written, exact. 0.1 is one tenth; text may also be a fraction, "1/3". */
export type Decimal = number | string;

/** The radii of atoms: "bondi", "alvarez", "pqr", "column:4" or a number, each with ",Fe=2.04" for an element. */
export interface Radii {
  radii: Decimal;
  /** Takes the atoms of a periodic cell for a finite set. */
  finite?: boolean;
}

export interface Fraction {
  /** "-3/4", or "5". */
  readonly text: string;
  readonly numerator: bigint;
  /** Above 0, without a common divisor. */
  readonly denominator: bigint;
}

/** Stationary points as columns. Numbers that would overflow are infinite; `exact()` has them. */
export interface StationaryPoints {
  readonly length: number;
  /** 0 to 3, or -1 for a regular stationary point. */
  readonly index: Int8Array;
  /** Two each: (i, i) if it is critical of index i; (1, 2), (1, 3) or (2, 3) if it is regular. */
  readonly kind: Int8Array;
  /** Three each. */
  readonly center: Float64Array;
  readonly squaredDistance: Float64Array;
  /** The nearest points of point i are `contacts.subarray(contactOffsets[i], contactOffsets[i + 1])`. */
  readonly contactOffsets: Uint32Array;
  readonly contacts: Uint32Array;
}

/**
 * A stationary point in JSON, which is critical but perhaps in pairs of length zero. Rationals are text; a double is
 * null where it would overflow.
 */
export interface StationaryPoint {
  record: number;
  contact: number[];
  center: [string, string, string];
  center_double: [number | null, number | null, number | null];
  squared_distance: string;
  squared_distance_double: number | null;
}

export interface PersistencePair {
  dimension: 0 | 1 | 2;
  birth: StationaryPoint;
  /** null: the class lasts. */
  death: StationaryPoint | null;
}

/** A cycle that stands for a pair (spec/formats/cycles.md). Contact sets name critical points. */
export interface Cycle {
  birth: StationaryPoint;
  death: StationaryPoint;
  length: number | null;
  squared_level?: string;
  /** Of dimension 1. */
  edges?: number[][];
  polygons?: number[][];
  surface?: number[][];
  loop_length?: number | null;
  witness?: Record<"loop" | "surface" | "cocycle" | "met", number[][]>;
  /** Of dimension 2. */
  maxima?: number[][];
  cell?: { index: number | [number, number]; contact: number[] }[];
  walls?: number[][];
  volume?: number | null;
  /** Of dimension 0. */
  components?: [number[], number[]];
}

/** An object of the program's --json. The keys beside these are in spec/formats/. */
export interface ProgramObject {
  format: string;
  format_version: number;
  version: string;
  [key: string]: any;
}
/** spec/formats/pockets.md */
export interface PocketsObject extends ProgramObject {
  pockets: { depth: number | null; volume: number | string | null; lining: number[]; [key: string]: any }[];
}
/** What pockets() gives where atoms have radii, and what pores() gives: spec/formats/pores.md */
export interface CavitiesObject extends ProgramObject {
  cavities: { lining: number[]; names?: string[] }[];
}
export interface PoresObject extends ProgramObject {
  largest_cavity_diameter: number | null;
  pore_limiting_diameter: number | null;
  chambers: { diameter: number; limiting_diameter: number | null; windows: number[]; [key: string]: any }[];
  windows: { diameter: number; contact: number[]; rooms: number[]; [key: string]: any }[];
}
/** What `flowcert check --json` says of a claim: src/cli/manual/check.md */
export interface CheckReport extends ProgramObject {
  verdict: "conforms" | "conforms where determined" | "perturbed" | "fails";
  grade: "exact" | "approximate";
  claim_format: string;
  findings: { reason: string; clause: string; line: number | null; sentence: string; [key: string]: any }[];
}

export interface CheckOptions {
  /** Of the claim's file, for messages; "claim" without it. The ending ".pers" says that it is a diagram. */
  name?: string;
  /** "pers" or "pores", where the content does not say it. */
  format?: "pers" | "pores";
  /** 1e-9 without it, and 1e-6 for pores. */
  tolerance?: number;
  /** The highest level that is judged, 1 to 5. */
  highestLevel?: number;
  /** Critical points of these indices alone are judged. */
  indices?: number[];
  /** For claims of pores. */
  radii?: Decimal;
  finite?: boolean;
}

export interface PageOptions {
  /** So many pairs of an index from 1 on, the longest. */
  most?: number;
  /** Also volumes, cells S3 and surfaces U1, so many of each. */
  cells?: boolean;
  mostCells?: number;
  mostUnstable?: number;
  /** Also pockets, merged by this persistence: "auto". */
  pockets?: Decimal;
  mostPockets?: number;
}

/**
 * The flow complex of points, which may be none, repeated or degenerate. Each part is computed when a method first
 * needs it, and kept. Its memory is WebAssembly's: call delete(), or declare it with `using`.
 */
export class FlowComplex {
  /**
   * points: x, y, z of each row, one row after the other; or the content of a file. They are copied. A text for
   * options is the name. Throws FlowcertError for what cannot be read, and Error where load() has not finished.
   */
  constructor(points: Float64Array | Uint8Array | ArrayBuffer, options?: FlowComplexOptions | string);

  readonly name: string;
  /** That of the file; "npy" for an array. */
  readonly format: string;
  /** What a user should know of how the file was read. line: 0 where there is none. */
  readonly notes: { line: number; text: string }[];
  /** Rows that were left out, from 0. */
  readonly leftOut: number[];
  /** Whether the file names atoms, so that radii by element are known. */
  readonly hasAtoms: boolean;
  /** Rows, with those that repeat another. */
  readonly pointCount: number;
  readonly mergedDuplicates: number;

  /** How many critical points of index 0, 1, 2 and 3 there are. */
  readonly counts: [number, number, number, number];
  /** How many regular stationary points of each kind. Usually there are none. */
  readonly regularCounts: Record<"1-2" | "1-3" | "2-3", number>;
  /** All: critical points by index, then regular ones by kind. */
  readonly stationaryPoints: StationaryPoints;
  /** The first part of them. */
  readonly criticalPoints: StationaryPoints;
  /** The doubles nearest to the centres of all stationary points, three each. */
  centers(): Float64Array;
  /** The exact centre and squared distance of stationary point i. */
  exact(i: number): { center: [Fraction, Fraction, Fraction]; squaredDistance: Fraction };

  /** All pairs, by dimension, birth and death. zero: regular stationary points as well, as pairs of length zero. */
  persistence(options?: { zero?: boolean }): PersistencePair[];
  /** The same in GUDHI's format .pers, squared, or plain distances. */
  persistenceText(options?: { zero?: boolean; plain?: boolean }): string;
  /**
   * What stands for pairs: loops around tunnels, with surfaces that fill them (dimension 1, without an option), voids
   * (2) or components (0). The longest 10; or those longer than `persistence`; or one pair, "3,17/5,8,20".
   * level: "25%", a distance, "birth" or "death".
   */
  cycles(options?: {
    dimension?: 0 | 1 | 2;
    longest?: number;
    persistence?: Decimal;
    pair?: string;
    level?: Decimal;
    witness?: boolean;
  }): Cycle[];

  /** Pockets between points. persistence: "auto" without it; probe: a radius, measured to the points. */
  pockets(options?: { persistence?: Decimal; probe?: Decimal; volumes?: "double" | "exact" }): Promise<PocketsObject>;
  /** Cavities between atoms, for a probe that is measured to their surfaces. */
  pockets(options: Radii & { probe: Decimal }): Promise<CavitiesObject>;
  /** Chambers between atoms, for probes of all radii, and their windows. depth: 0.1 without it. */
  pores(options: Radii & { depth?: Decimal; probe?: Decimal }): Promise<PoresObject>;

  /** All stationary points as lines of JSON: the file of `flowcert compute -o`, and a claim that check() takes. */
  records(options?: {
    manifolds?: "u2" | "s2" | "u2,s2" | "all";
    polylines?: boolean;
    skeletons?: boolean;
  }): Uint8Array;
  /**
   * The file of `flowcert surface`: stable manifolds of index-2 points. select: one condition or several, as
   * "index2-radius<1.6spacing", "persistence>auto" or "largest-gaps=20". format: "ply" without it.
   */
  surface(options?: { select?: string | string[]; format?: "ply" | "off" }): Uint8Array;
  /**
   * A page of HTML that shows the complex, or atoms as balls, without a network. It is free of the GPL (README.md). The
   * first call loads the page without data.
   */
  page(options?: PageOptions): Promise<Uint8Array>;
  page(options: Radii & { depth?: Decimal; probe?: Decimal }): Promise<Uint8Array>;

  /** Whether a claim about these points is right, by a second module, which the first call loads. */
  check(claim: string | Uint8Array | ArrayBuffer, options?: CheckOptions): Promise<CheckReport>;

  /** Gives back the memory. No method may be called afterwards. */
  delete(): void;
}
