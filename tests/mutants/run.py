#!/usr/bin/env python3
"""Mutation score of the quick tests: ./dev mutants (or tests/mutants/run.py) plants the faults of mutants.json in a
copy of the tracked tree, one at a time, builds, runs the quick tests until one fails, and prints which faults survive.
A fault that names its tests is tried by these, as ./dev test runs them.

With --test NAME it runs that one test of ctest's instead, at full scale, and prints which faults it kills; with
--survivors too, on those faults alone that the last run and earlier tests of this kind let live.

Guarantees: the work tree is not touched; everything happens below build-mutants/. Before the first fault all quick
tests must pass; a test's limit of processor time comes from that run, so that a busy machine kills nothing. A fault
that does not compile is an error of the table, not a kill. Exit status: 0; 1 where the score is below 95 % or a mutant
without a written reason survives; 2 where the table is wrong or the tests fail without a fault.
"""
import argparse
import concurrent.futures
import contextlib
import dataclasses
import json
import os
import pathlib
import queue
import re
import signal
import subprocess
import sys
import threading
import time

import table

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST_PERCENT = 95
# Enough inputs to kill, few enough to be quick.
ENVIRONMENT = {"FLOWCERT_PROPERTY_SCALE": "0.1", "GTEST_FAIL_FAST": "1", "CCACHE_NOHASHDIR": "1"}
MEMORY_LIMIT_KIB = 3 << 20
# A mutant in an endless loop is killed by processor time; one that sleeps, by the clock.
CPU_FACTOR, CPU_LEAST, CLOCK_LIMIT = 4, 4, 900

# The tests that are likely to kill a mutant of a file or folder run ahead of the others.
LIKELY = {
    "src/geometry/predicates": ["filter_bounds_test", "predicates_test"],
    "src/geometry/integer_grid": ["predicates_test"],
    "src/geometry/floating_point": ["floating_point_test"],
    "src/geometry/tetrahedron_signs": ["filter_bounds_test", "tetrahedron_signs_test"],
    "src/geometry/point_set": ["point_set_test"],
    "src/geometry/rational": ["rational_test"],
    "src/geometry/exact_sphere": ["explain_test"],
    "src/geometry/bounded": ["bounded_sphere_test"],
    "src/geometry/value_range": ["value_order_test", "squared_distances_test"],
    "src/geometry/enclosing_ball": ["explain_test"],
    "src/geometry/": ["flow_operator_test", "vectors_fast_test", "explain_test", "orbit_agreement_test",
                      "orbit_cascades_test"],
    "src/voronoi/delaunay_signs": ["delaunay_signs_test"],
    "src/voronoi/voronoi_complex": ["voronoi_complex_test"],
    "src/voronoi/voronoi_faces": ["voronoi_faces_test"],
    "src/voronoi/voronoi_diagram": ["voronoi_faces_test"],
    "src/flow/flow_statistics": ["flow_operator_test"],
    "src/flow/kernels/crossing_sphere": ["crossing_sphere_test"],
    "src/flow/rounded_stretches": ["rounded_manifolds_test"],
    "src/flow/": ["vectors_fast_test", "orbit_agreement_test", "unstable_agreement_test"],
    "src/morse/stationary_points": ["vectors_fast_test", "metamorphic_test", "stationary_agreement_test"],
    "src/flow/successor_forest": ["vectors_fast_test", "unstable_agreement_test"],
    "src/morse/unstable_manifolds": ["vectors_fast_test", "unstable_agreement_test"],
    "src/morse/persistence": ["vectors_fast_test", "persistence_test"],
    "src/morse/bounded_divisions": ["bounded_divisions_test"],
    "src/morse/connections": ["connection_agreement_test"],
    "src/morse/facet_regions": ["stable_regions_test"],
    "src/morse/forward_walk": ["unstable_surface_agreement_test"],
    "src/morse/limit_partition": ["limit_agreement_test", "volume_agreement_test"],
    "src/morse/merge_trees": ["pocket_agreement_test"],
    "src/morse/pocket": ["pockets_test", "pocket_agreement_test"],
    "src/morse/squared_distances": ["squared_distances_test", "pockets_test"],
    "src/morse/surface_area": ["pocket_agreement_test"],
    "src/morse/polygon_turn": ["limit_agreement_test", "volume_agreement_test"],
    "src/morse/stable_volumes": ["volume_agreement_test"],
    "src/morse/trace_set": ["unstable_surface_agreement_test"],
    "src/morse/unstable_surfaces": ["unstable_surface_agreement_test"],
    "src/morse/chain": ["vectors_fast_test", "persistence_test"],
    "src/morse/": ["vectors_fast_test", "stable_sets_test", "chain_complex_test", "stable_agreement_test"],
    "src/morse/value_order": ["value_order_test", "surface_choice_test"],
    "src/io/surface_selection": ["surface_choice_test"],
    "src/morse/saddle_radii": ["surface_choice_test"],
    "src/io/triangle_orientation": ["oriented_surfaces_test"],
    "src/io/medial_points": ["medial_agreement_test"],
    "src/morse/log_histogram": ["log_histogram_test", "surface_choice_test"],
    "src/io/atom_selection": ["read_molecule_test", "point_examples_test"],
    "src/io/crystal_cell": ["read_molecule_test", "point_examples_test"],
    "src/io/pdb_line": ["read_molecule_test", "moved_fields_test", "point_examples_test"],
    "src/io/point_": ["point_examples_test", "user_files_test"],
    "src/io/read_": ["point_examples_test", "moved_fields_test", "user_files_test"],
    "src/io/number_text": ["read_claim_test", "point_examples_test"],
    "src/io/table_columns": ["point_examples_test", "moved_fields_test"],
    "src/io/coordinate_rounding": ["coordinate_rounding_test"],
    "src/io/clip": ["clip_box_test", "clipped_lines_test"],
    "oracle/exact_geometry": ["oracle_geometry_test"],
    "oracle/point_set": ["oracle_stationary_test", "oracle_stable_test"],
    "oracle/stationary_points": ["oracle_stationary_test"],
    "oracle/orbit": ["oracle_orbit_test"],
    "oracle/stable": ["oracle_stable_test", "vectors_oracle_test"],
    "oracle/persistence": ["oracle_fast_test", "vectors_oracle_test"],
    "oracle/fast/": ["oracle_fast_test"],
    "oracle/program/": ["oracle_reading_test"],
    "tests/vectors/": ["oracle_stable_test", "vectors_oracle_test"],
    "fuzz/judge/drawn_cases": ["verification_test"],
    "fuzz/judge/oracle_truth": ["oracle_truth_test"],
    "fuzz/properties/stable_pieces": ["oracle_truth_test"],
    "fuzz/judge/peer_property": ["peer_property_test"],
    "fuzz/judge/": ["conformance_run_test"],
    "src/certify/placement": ["place_findings_test"],
    "src/certify/incidences": ["incidence_findings_test"],
    "src/certify/boundaries": ["incidence_findings_test"],
    "src/certify/polylines": ["polyline_findings_test"],
    "src/certify/leaving_segment": ["polyline_findings_test", "orbit_difference_test"],
    "src/certify/surfaces": ["stable_findings_test"],
    "src/certify/matching": ["matching_test"],
    "src/certify/claimed_rows": ["read_claim_test"],
    "src/certify/piece_comparison": ["stable_findings_test"],
    "src/certify/perturbed_point": ["perturbed_findings_test", "place_findings_test"],
    "src/certify/pockets": ["pocket_findings_test", "pocket_claims_test"],
    "src/certify/pair_differences": ["pair_differences_test"],
    "src/certify/profile": ["profile_test"],
    "src/certify/orbit_difference": ["orbit_difference_test"],
    "src/certify/programs/verification": ["verification_test"],
    "src/certify/programs/vector_cases": ["vector_cases_test"],
    "src/certify/programs/": ["conformance_run_test"],
    "src/certify/claims/read_pocket_claim": ["pocket_findings_test"],
    "src/certify/claims/pair_claim": ["pair_claim_test"],
    "src/certify/claims/orbit_claim": ["orbit_difference_test"],
    "src/certify/claims/": ["read_claim_test", "exchange_keys_test"],
    "src/certify/": ["check_test", "place_findings_test", "perturbed_claims_test"],
}

# Tests that do not reach a folder's code cannot kill its mutants.
OF_GEOMETRY = {"point_set_test", "rational_test", "filter_bounds_test", "predicates_test", "tetrahedron_signs_test"}
OF_ORACLE = {"oracle_connections_test", "oracle_fast_test", "oracle_geometry_test", "oracle_infinity_test",
             "oracle_location_test", "oracle_medial_axis_test", "oracle_merge_tree_test", "oracle_orbit_test",
             "oracle_pockets_test", "oracle_reading_test", "oracle_roots_test", "oracle_stable_test",
             "oracle_stationary_test", "vectors_oracle_test"}
OF_JUDGE = {"conformance_run_test", "oracle_truth_test", "peer_property_test", "vector_cases_test", "verification_test"}
BLIND = {
    "geometry": OF_ORACLE,
    "voronoi": OF_GEOMETRY | OF_ORACLE,
    "flow": OF_GEOMETRY | OF_ORACLE | {"voronoi_faces_test", "voronoi_complex_test", "explain_test", "metamorphic_test",
                           "invariants_test", "stationary_agreement_test"},
    "morse": OF_GEOMETRY | OF_ORACLE | {"voronoi_faces_test"},
}
# The other way round where few tests reach a folder: no other test can kill its mutants.
REACHED_BY = {
    "oracle": OF_ORACLE | OF_JUDGE | {
        "cech_persistence_test", "connection_agreement_test", "invariants_test", "limit_agreement_test",
        "medial_agreement_test", "metamorphic_test", "orbit_agreement_test", "orbit_cascades_test",
        "orbit_invariants_test", "persistence_test", "pocket_agreement_test", "pocket_claims_test",
        "stable_agreement_test", "stable_invariants_test", "stable_metamorphic_test", "stationary_agreement_test",
        "unstable_agreement_test", "unstable_surface_agreement_test", "volume_agreement_test"},
    "judge": OF_JUDGE,
    "vectors": {"oracle_stable_test", "vectors_oracle_test"},
    "certify": OF_JUDGE | {
        "check_mutations_test", "check_test", "direction_claims_test", "direction_findings_test", "exchange_keys_test",
        "finding_sentence_test", "incidence_findings_test", "infinity_claims_test", "matching_test",
        "orbit_difference_test", "pair_claim_test", "pair_claims_test", "pair_differences_test",
        "perturbed_claims_test", "perturbed_findings_test", "place_findings_test", "pocket_claims_test",
        "pocket_findings_test", "polyline_findings_test", "profile_test", "read_claim_test", "spec_examples_test",
        "stable_claims_test", "stable_findings_test", "unstable_set_findings_test"},
    "io": OF_JUDGE | {
        "atom_names_test", "clip_box_test", "clipped_lines_test", "coordinate_rounding_test", "direction_claims_test",
        "exchange_keys_test", "infinity_claims_test", "log_histogram_test", "medial_agreement_test",
        "moved_fields_test", "orbit_difference_test", "oriented_surfaces_test", "pair_claim_test",
        "place_findings_test", "pocket_claims_test", "pocket_findings_test", "pockets_test", "point_examples_test",
        "read_claim_test", "read_molecule_test", "spec_examples_test", "surface_choice_test", "user_files_test",
        "value_order_test", "vectors_fast_test"},
}


class BuildFailure(Exception):
    pass


class Interrupted(Exception):
    """Ctrl-C, which the running tools and tests get too: how they ended says nothing then."""


STOPPING = threading.Event()


def unless_stopping(done):
    if STOPPING.is_set():
        raise Interrupted
    return done


def give_up(message):
    print(f"error: {message}", file=sys.stderr)
    sys.exit(2)


# What tests that are scripts run.
PROGRAMS = ["flowcert_cli", "flowcert_oracle_tool"]
# FLOWCERT_PROPERTY_SCALE in ./dev test, and in ./dev test --slow.
USUAL_SCALE, FULL_SCALE = "1", "4"


@dataclasses.dataclass
class Outcome:
    killed: bool
    by: str = ""
    how: str = ""
    seconds: float = 0.0


def children_seconds():
    """The processor time of all programs that were run and have ended."""
    times = os.times()
    return times.children_user + times.children_system


class Copy:
    """A copy of the tracked tree with a build folder in it: compilers see the same relative paths in every copy."""

    def __init__(self, folder):
        self.folder, self.build, self.jobs = folder, folder / "build", os.cpu_count() or 1
        self.environment = {**ENVIRONMENT, "CCACHE_BASEDIR": str(folder.parent), **os.environ}
        self.environment.setdefault("GTEST_BRIEF", "1")

    def refresh(self):
        """Copies what differs, new files too, so that an earlier run's objects serve this one."""
        listing = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(listing, cwd=ROOT, check=True, capture_output=True, text=True).stdout
        for name in filter(None, names.split("\0")):
            source, target = ROOT / name, self.folder / name
            if not source.is_file() or (target.is_file() and target.read_bytes() == source.read_bytes()):
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(source.read_bytes())

    def run_tool(self, command):
        done = unless_stopping(subprocess.run(command, cwd=self.folder, env=self.environment, text=True,
                                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False))
        if done.returncode != 0:
            raise BuildFailure("\n".join(done.stdout.splitlines()[-25:]))
        return done.stdout

    def configure(self):
        # A fault may leave a variable without a use.
        self.run_tool(["cmake", "--preset", "release", "-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF"])

    def quick_tests(self):
        """Builds the tests with ctest's label `quick`. Returns their command lines, by name without folder.

        ctest knows the command line of a program only once it is built. The tests of GROUP/ are GROUP_tests."""
        self.compile(*{entry["name"].partition("/")[0] + "_tests" for entry in self.listed_tests()})
        tests = {entry["name"].rpartition("/")[2]: entry["command"] for entry in self.listed_tests()}
        named = set().union(*LIKELY.values(), *BLIND.values(), *REACHED_BY.values())
        unknown = named - tests.keys()
        if unknown:
            give_up(f"no quick test, but named here: {', '.join(sorted(unknown))}")
        return tests

    def listed_tests(self, *options):
        options = options or ("-L", "^quick$")
        listing = self.run_tool(["ctest", "--test-dir", "build", *options, "--show-only=json-v1"])
        return json.loads(listing)["tests"]

    def build_for(self, name):
        """Builds what the test of this name runs: the program of its tests, or what scripts run."""
        # ctest keeps silent about the command of a program that is not built yet.
        texts = "".join(path.read_text() for path in sorted(self.build.glob("*/*/CTestTestfile.cmake")))
        commands = re.findall(rf'^add_test\(\[=\[{re.escape(name)}]=] "([^"]+)"', texts, re.MULTILINE)
        if len(commands) != 1:
            give_up(f"ctest has {len(commands)} tests {name}")
        program = pathlib.Path(commands[0])
        if program.is_relative_to(self.build):
            self.compile(program.name)
        else:
            self.compile(*PROGRAMS, *(["flowcert_python"] if name.startswith("python/") else []))

    def run_whole(self, name, cpu_limit, scale):
        """Builds a test and runs it as ctest does. Returns how it ended (None if it passes), and the processor time."""
        self.build_for(name)
        environment = {**self.environment, "FLOWCERT_PROPERTY_SCALE": scale}
        limited = f'ulimit -c 0; ulimit -t {cpu_limit}; exec "$0" "$@"'
        command = ["ctest", "--test-dir", "build", "-R", f"^{name}$", "--timeout", str(CLOCK_LIMIT), "--no-tests=error"]
        before = children_seconds()
        done = unless_stopping(subprocess.run(["sh", "-c", limited, *command], cwd=self.folder, env=environment,
                                              check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        return (None if done.returncode == 0 else "a failure"), children_seconds() - before

    def compile(self, *targets):
        self.run_tool(["cmake", "--build", "build", "--parallel", str(self.jobs), "--target", *targets])

    def run(self, command, cpu_limit):
        """Builds and runs a quick test. Returns how it ended (None if it passes), and the processor time it took."""
        self.compile(program_of(command))
        program = self.build / pathlib.Path(command[0]).relative_to(pathlib.Path(command[0]).parents[2])
        limited = f'ulimit -c 0; ulimit -v {MEMORY_LIMIT_KIB}; ulimit -t {cpu_limit}; exec "$0" "$@"'
        command = ["sh", "-c", limited, str(program), *command[1:]]
        before = children_seconds()
        try:
            done = subprocess.run(command, cwd=self.build, env=self.environment, timeout=CLOCK_LIMIT, check=False,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            code = unless_stopping(done).returncode
        except subprocess.TimeoutExpired:
            return "time limit", CLOCK_LIMIT
        used = children_seconds() - before
        if code == 0:
            return None, used
        return ("a failure" if code == 1 else "time limit" if code in (-24, -9, 128 + 9) else f"signal {-code}"), used


def program_of(command):
    """The build's target for a test's command line."""
    return pathlib.Path(command[0]).name


def order_for(entry, limits):
    """Names of tests: what is likely to kill comes first, then what takes least time."""
    likely = [name for prefix, names in LIKELY.items() if entry["file"].startswith(prefix) for name in names]
    folder = table.folder_of(entry)
    blind = BLIND.get(folder, set()) | (limits.keys() - REACHED_BY.get(folder, limits.keys()))
    return [name for name in dict.fromkeys(likely + sorted(limits, key=limits.get)) if name not in blind]


@contextlib.contextmanager
def planted(copy, entry):
    path = copy.folder / entry["file"]
    original = path.read_text(encoding="utf-8")
    path.write_text(table.mutated(entry, original), encoding="utf-8")
    try:
        yield
    finally:
        path.write_text(original, encoding="utf-8")


def try_mutant(copy, entry, tests, limits):
    """By the whole tests that the fault names, or else by the quick tests."""
    if table.TESTS in entry:
        return try_by(copy, entry, entry[table.TESTS], lambda name: copy.run_whole(name, limits[name], USUAL_SCALE))
    order = order_for(entry, {name: limits[name] for name in tests})
    return try_by(copy, entry, order, lambda name: copy.run(tests[name], limits[name]))


def try_by(copy, entry, names, run):
    """Runs these tests, as Copy.run does, until one fails."""
    start = time.monotonic()
    with planted(copy, entry):
        for name in names:
            ending, _ = run(name)
            if ending is not None:
                return Outcome(True, name, ending, time.monotonic() - start)
        return Outcome(False, seconds=time.monotonic() - start)


def measure_limits(copy, tests, whole, scale):
    """Runs every quick test without a fault, and the whole ones that faults name."""
    limits = {}
    for name in [*tests, *sorted(whole)]:
        if name in tests:
            ending, used = copy.run(tests[name], CLOCK_LIMIT)
        else:
            ending, used = copy.run_whole(name, CLOCK_LIMIT, scale)
        if ending is not None:
            give_up(f"without a fault, {name} ends with {ending}")
        limits[name] = int(max(CPU_LEAST, CPU_FACTOR * used)) + 1
        print(f"  {name:28} {used:6.1f} s", flush=True)
    return limits


class Results:
    """What is known of each mutant, kept in a file after each."""

    def __init__(self, path, resume):
        self.path, self.lock, self.known, self.by_test = path, threading.Lock(), {}, {}
        if resume and path.is_file():
            kept = json.loads(path.read_text(encoding="utf-8"))
            self.known, self.by_test = kept["mutants"], kept.get("by_test", {})

    @staticmethod
    def edit_of(entry):
        return [entry["file"], entry["old"], entry["new"]]

    def killed_before(self, entry):
        """A survivor is tried again: there may be a new test."""
        known = self.known.get(entry["id"], {})
        return known.get("killed", False) and known["edit"] == self.edit_of(entry)

    def keep(self, entry, outcome, test=None):
        """What the quick tests made of it, or this one whole test."""
        with self.lock:
            of = self.known if test is None else self.by_test.setdefault(test, {})
            of[entry["id"]] = {**dataclasses.asdict(outcome), "edit": self.edit_of(entry)}
            kept = {"mutants": self.known, "by_test": self.by_test}
            self.path.write_text(json.dumps(kept, indent=1), encoding="utf-8")

    def survivors(self, entries, test):
        """Those that neither the quick tests nor any whole test but this one has killed."""
        untried = [entry["id"] for entry in entries if entry["id"] not in self.known and reason_of(entry) is None]
        if untried:
            give_up(f"{len(untried)} faults were never tried, as {untried[0]}: ./dev mutants --resume tries them")
        others = [outcomes for name, outcomes in self.by_test.items() if name != test]
        return [entry for entry in entries if "equivalent" not in entry and not self.killed_before(entry)
                and not any(of.get(entry["id"], {}).get("killed") for of in others)]


def reason_of(entry):
    return next((f"{kind}: {entry[kind]}" for kind in sorted(table.REASONS) if kind in entry), None)


def describe(entry, outcome):
    if outcome.killed:
        return f"{entry['id']}: killed by {outcome.by} ({outcome.how}) after {outcome.seconds:.0f} s"
    return f"{entry['id']}: SURVIVED, {outcome.seconds:.0f} s: {entry['wrong']}"


def built(copies, what, build):
    """Brings each copy up to date and builds it without a fault, with all processors. From then on they share these.
    Returns what `build` returned of the last one."""
    for copy in copies:
        print(f"building {what} in {copy.folder.relative_to(ROOT)}/", flush=True)
        copy.refresh()
        try:
            copy.configure()
            tests = build(copy)
        except BuildFailure as failure:
            give_up(f"without a fault:\n{failure}")
    for copy in copies:
        copy.jobs = max(1, copy.jobs // len(copies))
    return tests


def run_all(entries, results, copies):
    """Tries each entry on the next copy that is free. Returns what did not compile."""
    tests = built(copies, "the quick tests", Copy.quick_tests)
    print("processor time without a fault")
    whole = set().union(*(entry.get(table.TESTS, ()) for entry in entries))
    limits = measure_limits(copies[0], tests, whole, USUAL_SCALE)
    return try_all(entries, copies, lambda copy, entry: try_mutant(copy, entry, tests, limits), results, None)


def run_one_test(name, entries, results, copies):
    """Tries each entry by one test at full scale. Returns what did not compile."""
    built(copies, name, lambda copy: copy.build_for(name))
    limits = measure_limits(copies[0], {}, {name}, FULL_SCALE)

    def attempt(copy, entry):
        return try_by(copy, entry, [name], lambda _: copy.run_whole(name, limits[name], FULL_SCALE))

    broken = try_all(entries, copies, attempt, results, name)
    killed = [entry["id"] for entry in entries if results.by_test.get(name, {}).get(entry["id"], {}).get("killed")]
    print(f"\n{name} kills {len(killed)} of {len(entries)}: {', '.join(killed) or 'none'}")
    return broken


def try_all(entries, copies, attempt, results, test):
    free, broken = queue.SimpleQueue(), []
    for copy in copies:
        free.put(copy)

    def task(entry):
        copy = free.get()
        try:
            unless_stopping(None)
            outcome = attempt(copy, entry)
            results.keep(entry, outcome, test)
            print(describe(entry, outcome), flush=True)
        except BuildFailure as failure:
            broken.append(entry["id"])
            print(f"{entry['id']}: DOES NOT COMPILE\n{failure}", flush=True)
        except Interrupted:
            pass
        finally:
            free.put(copy)

    with concurrent.futures.ThreadPoolExecutor(len(copies)) as pool:
        list(pool.map(task, entries))
    return unless_stopping(broken)


def report(entries, results):
    """Prints the table by folder. Returns whether all is well."""
    rows, survivors = {}, []
    for entry in entries:
        row = rows.setdefault(table.folder_of(entry), [0, 0, 0, 0])
        killed = results.known.get(entry["id"], {}).get("killed", False)
        row[0 if killed else 1 if "equivalent" in entry else 2 if "accepted" in entry else 3] += 1
        if not killed:
            survivors.append(entry)
    rows["all"] = [sum(column) for column in zip(*rows.values())]
    print(f"\n{'folder':10} {'mutants':>8} {'killed':>8} {'equivalent':>11} {'accepted':>9} {'survived':>9}")
    for folder, (killed, equivalent, accepted, alive) in rows.items():
        total = killed + equivalent + accepted + alive
        print(f"{folder:10} {total:8} {killed:8} {equivalent:11} {accepted:9} {alive:9}")
    for entry in survivors:
        print(f"{entry['id']}: {reason_of(entry) or 'SURVIVED: ' + entry['wrong']}")
    killed, _, accepted, alive = rows["all"]
    percent = 100 * killed / max(1, killed + accepted + alive)
    print(f"mutation score: {percent:.1f} % of {killed + accepted + alive} (equivalent ones apart; "
          f"at least {LEAST_PERCENT} % asked)")
    return percent >= LEAST_PERCENT and alive == 0


def spread(entries):
    """Puts neighbours in the table far apart, so that an interrupted run has seen every folder."""
    step = 11
    return [entry for start in range(step) for entry in entries[start::step]]


def arguments():
    parser = argparse.ArgumentParser(prog="./dev mutants", description="mutation score of the quick tests")
    parser.add_argument("--only", metavar="ID", action="append", help="this mutant alone, reason or not; repeatable")
    parser.add_argument("--test", metavar="NAME", help="try the faults by this test alone, quick or not, at full scale")
    parser.add_argument("--survivors", action="store_true", help="with --test: only faults that no test killed so far")
    parser.add_argument("--list", action="store_true", help="print the table and stop")
    parser.add_argument("--check", action="store_true", help="check that every entry applies, and stop")
    parser.add_argument("--jobs", type=int, default=1, help="how many copies of the tree work at a time (1)")
    parser.add_argument("--resume", action="store_true", help="keep the kills of the last run, go on with the rest")
    options = parser.parse_args()
    if options.survivors and not options.test:
        parser.error("--survivors goes with --test")
    return options


def chosen(entries, only):
    if not only:
        return entries
    unknown = set(only) - {entry["id"] for entry in entries}
    if unknown:
        give_up(f"no such mutant: {', '.join(sorted(unknown))}")
    return [entry for entry in entries if entry["id"] in only]


def main():
    options = arguments()
    entries = table.read()
    faults = table.faults_of(entries, ROOT)
    if faults:
        print("\n".join(["the table of mutants is wrong:", *faults]), file=sys.stderr)
        return 2
    if options.check:
        print(f"{len(entries)} mutants, each of them applies")
        return 0
    entries = chosen(entries, options.only)
    if options.list:
        for entry in entries:
            print(f"{entry['id']} ({entry['file']}): {entry['wrong']}")
        return 0
    work = ROOT / "build-mutants"
    work.mkdir(exist_ok=True)
    results = Results(work / "results.json", options.resume or options.only or options.test)
    if options.survivors:
        entries = results.survivors(entries, options.test)
        if not entries:
            print(f"no fault is left alive for {options.test}")
            return 0
    to_try = entries if options.test else [entry for entry in entries
              if options.only or (reason_of(entry) is None and not results.killed_before(entry))]
    copies = [Copy(work / ("source" if k == 0 else f"source-{k + 1}")) for k in range(max(1, options.jobs))]
    start = time.monotonic()
    signal.signal(signal.SIGINT, lambda *_: STOPPING.set())
    try:
        if options.test:
            broken = run_one_test(options.test, spread(to_try), results, copies)
        else:
            broken = run_all(spread(to_try), results, copies) if to_try else []
    except Interrupted:
        print("interrupted; --resume goes on", file=sys.stderr)
        return 130
    well = options.test or report(entries, results)
    print(f"{len(to_try)} mutants in {(time.monotonic() - start) / 60:.0f} minutes")
    if broken:
        print(f"error: does not compile: {', '.join(broken)}", file=sys.stderr)
        return 2
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
