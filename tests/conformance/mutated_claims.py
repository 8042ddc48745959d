"""Claims that are wrong, or right in another way, made from right ones: for tests of those who judge claims.

Everything is drawn from a seed. A mutated claim can by chance be right, and it can be one that nobody can read.
"""
import copy
import itertools
import json
import re
from fractions import Fraction


def claim_of(text):
    lines = [json.loads(line) for line in text.splitlines()]
    return lines[0], lines[1:]


def text_of(head, records):
    return "".join(json.dumps(one) + "\n" for one in [head, *records])


def perturbed_points(points, rng):
    """The points, each moved by very little. Equal points stay equal."""
    span = max((abs(x) for p in points for x in p), default=0.0) or 1.0
    step = span * 2.0 ** rng.choice([-30, -20, -16])
    moved = {}
    for p in points:
        key = tuple(x + 0.0 for x in p)
        moved.setdefault(key, [x + step * rng.uniform(-1, 1) for x in p])
    return [moved[tuple(x + 0.0 for x in p)] for p in points]


# ---- One change of a claim in the exchange format. Each takes a header, records, how many rows there are, and a
# generator of random numbers.


def any_record(records, rng, wanted=lambda record: True):
    found = [record for record in records if wanted(record)]
    return rng.choice(found) if found else {"index": 0, "contact": [0]}


def is_saddle(record):
    return record["index"] == 2


def drop(head, records, rows, rng):
    if records:
        records.pop(rng.randrange(len(records)))


def repeat(head, records, rows, rng):
    if records:
        records.insert(rng.randrange(len(records)), copy.deepcopy(rng.choice(records)))


def other_index(head, records, rows, rng):
    record = any_record(records, rng)
    record["index"] = rng.choice([0, 1, 2, 3, [1, 2], [2, 3], [1, 3], 4])
    record["kind"] = "regular" if isinstance(record["index"], list) else "critical"
    for key in ("samples", "limits", "stable"):
        record.pop(key, None)


def as_critical(head, records, rows, rng):
    record = any_record(records, rng, lambda one: isinstance(one["index"], list))
    if isinstance(record["index"], list):
        record["index"] = rng.choice(record["index"])
        record["kind"] = "critical"
        record.pop("stable", None)


def contact_replaced(head, records, rows, rng):
    contact = any_record(records, rng)["contact"]
    contact[rng.randrange(len(contact))] = rng.randrange(rows)


def contact_smaller(head, records, rows, rng):
    record = any_record(records, rng, lambda one: len(one["contact"]) > 1)
    if len(record["contact"]) > 1:
        record["contact"].pop(rng.randrange(len(record["contact"])))


def contact_larger(head, records, rows, rng):
    any_record(records, rng)["contact"].append(rng.randrange(rows))


def contact_part(head, records, rows, rng):
    """Often what FC-CLAIM-02 permits."""
    record = any_record(records, rng, lambda one: len(one["contact"]) > 3)
    size = (record["index"][-1] if isinstance(record["index"], list) else record["index"]) + 1
    if len(record["contact"]) > size:
        record["contact"] = sorted(rng.sample(record["contact"], size))


def outside_row(head, records, rows, rng):
    any_record(records, rng)["contact"].append(rows)


def center_moved(head, records, rows, rng):
    record = any_record(records, rng, lambda one: "center" in one)
    step = Fraction(rng.choice([1, -1])) * Fraction(1, 2 ** rng.choice([1, 20, 44, 60]))
    if "center" in record:
        axis = rng.randrange(3)
        record["center"][axis] = str(Fraction(record["center"][axis]) + step)


def square_changed(head, records, rows, rng):
    record = any_record(records, rng, lambda one: "squared_distance" in one)
    if "squared_distance" in record:
        value = Fraction(record["squared_distance"])
        record["squared_distance"] = str(value * (1 + Fraction(1, 2 ** rng.choice([1, 30, 50, 100]))))


def double_changed(head, records, rows, rng):
    record = any_record(records, rng, lambda one: one.get("center_double"))
    if record.get("center_double"):
        record["center_double"][rng.randrange(3)] = rng.choice([None, 0, 1e-30, 1e300, 0.5])


def square_double_changed(head, records, rows, rng):
    record = any_record(records, rng)
    record["squared_distance_double"] = rng.choice([None, 0, 0.25, 2.0])


def decimals_alone(head, records, rows, rng):
    digits = rng.choice([3, 8, 10, 17])
    for record in records:
        record.pop("center", None)
        record.pop("squared_distance", None)
        if rng.random() < 0.5 and record.get("center_double"):
            record.pop("contact", None)
            record["center_double"] = [x if x is None else float(f"{x:.{digits}g}") for x in record["center_double"]]


def positions_alone(head, records, rows, rng):
    for record in records:
        if "center" in record and rng.random() < 0.7:
            record.pop("contact", None)


def limit_changed(head, records, rows, rng):
    record = any_record(records, rng, lambda one: "limits" in one)
    others = [None] + [one["contact"] for one in records if "contact" in one]
    if "limits" in record:
        record["limits"][rng.randrange(2)] = copy.deepcopy(rng.choice(others))


def limits_swapped(head, records, rows, rng):
    record = any_record(records, rng, lambda one: one.get("limits", [0, 0])[0] != one.get("limits", [0, 0])[1])
    if isinstance(record.get("limits"), list):
        record["limits"].reverse()


def limit_part(head, records, rows, rng):
    named = [one for record in records for one in record.get("limits", []) if isinstance(one, list) and len(one) > 4]
    if named:
        chosen = rng.choice(named)
        chosen[:] = sorted(rng.sample(chosen, 4))


def samples_changed(head, records, rows, rng):
    record = any_record(records, rng, lambda one: "samples" in one)
    if "samples" in record:
        record["samples"][rng.randrange(2)] = rng.randrange(rows)


def boundary_changed(head, records, rows, rng):
    record = any_record(records, rng, lambda one: "boundary" in one.get("stable", {}))
    others = [one["contact"] for one in records if one["index"] == 1 and "contact" in one]
    boundary = record.get("stable", {}).get("boundary")
    if boundary is None or not others:
        return
    if boundary and rng.random() < 0.5:
        boundary.pop(rng.randrange(len(boundary)))
    else:
        boundary.append(list(rng.choice(others)))


def boundary_added(head, records, rows, rng):
    """The sum of two boundaries: a cycle, but usually not the boundary of a point."""
    saddles = [one for one in records if "boundary" in one.get("stable", {})]
    if len(saddles) > 1:
        first, second = rng.sample(saddles, 2)
        pairs = {tuple(edge) for edge in first["stable"]["boundary"]} ^ {tuple(e) for e in second["stable"]["boundary"]}
        first["stable"]["boundary"] = [list(edge) for edge in sorted(pairs)]


def head_changed(head, records, rows, rng):
    values = {"points": rows + 1, "merged_duplicates": rows, "critical": [1, 1, 1, 1],
              "regular_stationary": {"1-2": 1, "1-3": 0, "2-3": 0}, "classes": [[0, 1]], "input_sha256": "0" * 64,
              "indices": sorted(rng.sample(range(4), 3))}
    key = rng.choice(sorted(values))
    head[key] = values[key]


def indices_fewer(head, records, rows, rng):
    indices = sorted(rng.sample(range(4), rng.choice([1, 2, 3])))
    head["indices"] = indices
    records[:] = [one for one in records if isinstance(one["index"], list) or one["index"] in indices]


def without_regular(head, records, rows, rng):
    records[:] = [one for one in records if not isinstance(one["index"], list)]
    head["regular_stationary"] = {"1-2": 0, "1-3": 0, "2-3": 0}
    if rng.random() < 0.5:
        head.pop("regular_stationary")


def made_of_simplex(head, records, rows, rng):
    """Faces instead of a stationary point: sometimes what a perturbation makes of it (FC-CLAIM-04)."""
    record = any_record(records, rng, lambda one: len(one.get("contact", [])) > 2)
    contact = record.get("contact", [])
    if len(contact) < 3 or record not in records:
        return
    faces = [list(one) for size in (2, 3, 4) for one in itertools.combinations(contact[:8], size)]
    if rng.random() < 0.6:
        records.remove(record)
    for face in rng.sample(faces, min(len(faces), rng.choice([1, 2, 2, 3, 4]))):
        records.append({"index": len(face) - 1, "contact": face})


def order_changed(head, records, rows, rng):
    """Of records, of the rows in contact sets, and of the pieces of all sorts that have no order."""
    rng.shuffle(records)
    for record in records:
        rng.shuffle(record.get("contact", []))
        stable, skeleton = record.get("stable", {}), record.get("skeleton", {})
        unstable = record.get("u1", {}) if isinstance(record.get("u1"), dict) else {}
        pieces = [stable.get("boundary"), record.get("connections"), record.get("shares_double"),
                  skeleton.get("intervals"), skeleton.get("sectors"), *unstable.values()]
        for some in pieces:
            if isinstance(some, list):
                rng.shuffle(some)


def centers_of_samples(records):
    return {one["contact"][0]: [Fraction(x) for x in one["center"]]
            for one in records if one["index"] == 0 and "center" in one}


def coplanar(contact, three, at):
    """Those of a contact set that are in the plane of three."""
    a, b, c = (at[name] for name in three)
    u, v = ([x - y for x, y in zip(one, a)] for one in (b, c))
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    return [one for one in contact if sum(k * (x - y) for k, x, y in zip(n, at[one], a)) == 0]


def kept_face(head, records, rows, rng):
    """Polygons of a contact set that stay on their circles, with a further sample or without, and other parts of it."""
    at = centers_of_samples(records)
    large = [one for one in records if len(one.get("contact", [])) > 4 and all(name in at for name in one["contact"])]
    if not large:
        return
    record = rng.choice(large)
    contact = record["contact"]
    if rng.random() < 0.8:
        records.remove(record)
    for _ in range(rng.choice([1, 1, 2, 3, 4])):
        polygon = coplanar(contact, rng.sample(contact, 3), at)
        rest = [one for one in contact if one not in polygon]
        index = rng.choice([2, 3]) if rest else 2
        records.append({"index": index, "contact": sorted(polygon + (rng.sample(rest, 1) if index == 3 else []))})
    if rng.random() < 0.4:
        head["indices"] = sorted(rng.sample(range(4), rng.choice([2, 3])))
        records[:] = [one for one in records if isinstance(one["index"], list) or one["index"] in head["indices"]]


def near_several(head, records, rows, rng):
    """Positions that are right, or nearly so, within a tolerance that the judges are given, and no contact sets."""
    size = rng.choice([1e-10, 1e-7, 1e-4, 1e-3])
    for record in records:
        near = record.get("center_double")
        if near and None not in near and "contact" in record and rng.random() < 0.8:
            length = max([(record.get("squared_distance_double") or 0) ** 0.5, *map(abs, near)])
            record["center_double"] = [x + size * length * rng.uniform(-0.6, 0.6) for x in near]
            record.pop("contact")
            record.pop("center", None)
            if rng.random() < 0.6:
                record.pop("squared_distance", None)
                record.pop("squared_distance_double", None)
    if records and rng.random() < 0.3:
        records.append(copy.deepcopy(rng.choice(records)))


def key_misplaced(head, records, rows, rng):
    any_record(records, rng)[rng.choice(["samples", "limits", "kind"])] = rng.choice([[0, 1], "critical", [None, None]])


CHANGES = [drop, repeat, other_index, as_critical, contact_replaced, contact_smaller, contact_larger, contact_part,
           outside_row, center_moved, square_changed, double_changed, square_double_changed, decimals_alone,
           positions_alone, limit_changed, limits_swapped, limit_part, samples_changed, boundary_changed,
           boundary_added, head_changed, indices_fewer, without_regular, made_of_simplex, made_of_simplex,
           key_misplaced, order_changed, kept_face, kept_face, near_several]
# Those that leave other keys out, so that they come last.
LAST = [decimals_alone, positions_alone, near_several]


def recounted(head, records):
    """The header's counts, as the records have them. A wrong count would hide nothing, but every claim would fail."""
    counts = [sum(1 for one in records if one["index"] == k) for k in range(4)]
    kinds = {kind: sum(1 for one in records if one["index"] == [int(kind[0]), int(kind[2])])
             for kind in ("1-2", "1-3", "2-3")}
    head["critical"] = counts
    if "regular_stationary" in head:
        head["regular_stationary"] = kinds


def mutated(text, rows, rng):
    head, records = claim_of(text)
    changes = rng.sample(CHANGES, rng.choice([1, 1, 2, 3])) if rows else []
    for change in changes:
        if change in LAST:
            continue
        change(head, records, rows, rng)
    if head_changed not in changes and rng.random() < 0.9:
        recounted(head, records)
    for change in [one for one in LAST if one in changes]:
        change(head, records, rows, rng)
    return text_of(head, records)


# ---- Other formats


def as_csv(text, rng):
    """Decimals of some digits, with contact ids or without."""
    _, records = claim_of(text)
    digits, with_contact, with_square = rng.choice([6, 10, 12, 17]), rng.random() < 0.4, rng.random() < 0.6
    lines = ["index,x,y,z,squared_distance"] if rng.random() < 0.5 else ["# by some program"]
    for record in records:
        if isinstance(record["index"], list) or record.get("center_double") is None or None in record["center_double"]:
            continue
        fields = [str(record["index"])] + [f"{x:.{digits}g}" for x in record["center_double"]]
        square = record.get("squared_distance_double")
        fields.append(f"{square:.{digits}g}" if with_square and square is not None else "")
        lines.append(",".join(fields + [str(one) for one in record["contact"] if with_contact]))
    if rng.random() < 0.5 and len(lines) > 1:
        lines.pop(rng.randrange(1, len(lines)))
    return "\n".join(lines) + "\n"


def as_bars(text, rng):
    """The format of Giesen and Kuehne, with what is above each point. Contact sets of five and more become parts."""
    _, records = claim_of(text)
    critical = [one for one in records if not isinstance(one["index"], list)]

    def named(contact, index):
        return " ".join(map(str, sorted(rng.sample(contact, index + 1)) if len(contact) > index + 1 else contact))

    index_of = {tuple(one["contact"]): one["index"] for one in critical}
    lines = ["inf 3"]
    for record in critical:
        above = []
        if record["index"] < 2:
            for other in critical:
                down = other.get("stable", {}).get("boundary", []) if record["index"] else \
                    [[one] for one in other["contact"]]
                if other["index"] == record["index"] + 1 and record["contact"] in down:
                    above.append(named(other["contact"], other["index"]))
            above += ["inf"] if record["index"] == 1 and (not above or rng.random() < 0.05) else []
        for limit in record.get("limits", []) if record["index"] == 2 else []:
            above.append("inf" if limit is None else named(limit, index_of.get(tuple(limit), min(len(limit) - 1, 3))))
        if above and rng.random() < 0.03:
            above.pop()
        if rng.random() < 0.03:
            above.append(named(rng.choice(critical)["contact"], 0))
        distance = f"{(record['squared_distance_double'] or 0) ** 0.5:.15g}"
        lines.append(" | ".join([named(record["contact"], record["index"]), distance, *above]) + " |")
    return "\n".join(lines) + "\n"


# ---- The letters of numbers and lines (FC-FILE-47)


def other_number(text, rng):
    """A decimal or a fraction in another spelling, or in one that is none."""
    sign, digits = ("-", text[1:]) if text[:1] == "-" else ("", text)
    forms = [text, sign + "0" + digits, text + "e0", text + "E+00", text + "e-0"] if "e" not in text else [text]
    if not sign:
        forms.append("+" + digits)
    if digits.isdigit():
        forms += [text + ".", text + ".0", sign + hex(int(digits)) if len(digits) < 15 else text, text + "/1"]
    if digits[:2] == "0.":
        forms.append(sign + digits[1:])
    wrong = ["--" + digits, ".", "1_0", *(text + end for end in ("e", "x", "/0", " 1", "\u0660", "e701"))]
    return rng.choice(wrong) if rng.random() < 0.02 else rng.choice(forms)


def respelled(text, rng):
    """The same claim with other numbers, other ends of lines and other blanks; rarely one that nobody can read."""
    is_json = text[:1] == "{"
    if rng.random() < 0.7:
        number = r"-?[0-9.]+(?:/[0-9]+)?(?:e[-+]?[0-9]+)?"
        pattern = f'(?<="){number}(?=")' if is_json else f"(?<=,){number}(?=,)"
        text = re.sub(pattern, lambda found: found[0] if "/" in found[0] else other_number(found[0], rng), text)
    if rng.random() < 0.7:
        end = rng.choice(["\n", "\r\n", "\r", "\n\n", "\r\n\r", "\n \t\n", "\n\v\f\n"])
        text = text.replace("\n", end)
    if not is_json and rng.random() < 0.4:
        text = text.replace(",", rng.choice([" , ", ", ", "\t,\v", " "])) if ",," not in text else text
    if rng.random() < 0.3:
        text = rng.choice(["\ufeff", "\ufeff", "\n", " \f\n", "\ufeff\ufeff", "\u00a0"]) + text
    return text if rng.random() < 0.7 else text.rstrip()


# ---- Orbits


def damaged_orbit(orbit, rng):
    """An orbit of which one thing is wrong, or permitted."""
    orbit = copy.deepcopy(orbit)
    segments, limit = orbit["segments"], orbit["limit"]
    what = rng.randrange(8)
    segment = rng.choice(segments) if segments else {}
    if what == 0 and segments:
        segment["type"] = rng.choice(["E-F-E", "E-F-V", "E-E-V", "V-E-V", "V-F-E", "F-F-E", "C-C-F", "Q", "E-E-inf"])
    elif what == 1 and segments:
        segment["type"] = segment["type"][:4] + rng.choice(["V", "E", "F", "inf"])
    elif what == 2 and segments:
        segment["driver"][rng.randrange(3)] = "1/3"
    elif what == 3 and segments:
        segment["end"] = rng.choice([None, ["0", "0", "0"], segment["driver"]])
    elif what == 4 and segments:
        key = rng.choice(["start_contact", "crossed_contact", "end_contact"])
        rows = segment.get(key) or [0]
        segment[key] = rng.choice([None, rows[:-1], rows + [max(rows) + 1], rows])
    elif what == 5 and segments:
        segments.pop(rng.randrange(len(segments)))
    elif what == 6 and limit["kind"] != "infinity":
        key = rng.choice(["kind", "index", "contact", "squared_distance"])
        limit[key] = {"kind": "critical", "index": rng.choice([0, 1, 2, 3, [1, 2], [1, 3]]), "contact": [0, 1],
                      "squared_distance": "999"}[key]
    elif what == 7:
        orbit["limit"] = {**dict.fromkeys(limit), "kind": "infinity"}
    return orbit
