"""Lists of stationary points, as `flowcert compute` writes them, with one thing wrong."""
import json
import math


def near(x, rng):
    return math.nextafter(x or 0.0, rng.choice((-math.inf, math.inf)))


def at_an_axis(change):
    def changed(values, rng):
        k = rng.randrange(3)
        return [*values[:k], change(values[k], rng), *values[k + 1:]]
    return changed


def one_more(numbers, rng):
    k = rng.randrange(len(numbers))
    return [*numbers[:k], numbers[k] + 1, *numbers[k + 1:]]


RECORD = {  # by key: other values
    "index": [lambda x, rng: rng.choice([y for y in (0, 1, 2, 3, 12, [1, 2], [1, 3], [2, 3]) if y != x])],
    "kind": [lambda x, rng: "regular" if x == "critical" else "critical"],
    "contact": [one_more, lambda x, rng: x[:-1], lambda x, rng: [*x, x[-1] + 1], lambda x, rng: [*x, x[-1]]],
    "center": [at_an_axis(lambda x, rng: x + "1"), at_an_axis(lambda x, rng: "-" + x), at_an_axis(
        lambda x, rng: f"{2 * int(x.split('/')[0])}/{2 * int((x + '/1').split('/')[1])}")],
    "squared_distance": [lambda x, rng: x + "1", lambda x, rng: x + "/1", lambda x, rng: "-" + x],
    "center_double": [at_an_axis(near), at_an_axis(lambda x, rng: None), at_an_axis(lambda x, rng: (x or 0.0) + 1)],
    "squared_distance_double": [near, lambda x, rng: None, lambda x, rng: (x or 0.0) + 1],
}
HEADER = {
    "format": [lambda x, rng: "flowcert-persistence"],
    "format_version": [lambda x, rng: x + 1],
    "input_sha256": [lambda x, rng: x[1:] + ("1" if x[0] == "0" else "0")],
    "points": [lambda x, rng: x + 1, lambda x, rng: x - 1],
    "merged_duplicates": [lambda x, rng: x + 1],
    "critical": [one_more, lambda x, rng: x[:3]],
    "regular_stationary": [lambda x, rng: {**x, rng.choice(["1-2", "1-3", "2-3"]): 7 + max(x.values())}],
    "classes": [lambda x, rng: [*x, [0, 1]], lambda x, rng: x[:-1] if x else [[0]]],
    "centers": [lambda x, rng: rng.choice(["exact", "double", "none"])],
}


def forged(text, rng):
    """Pairs: what is wrong, and the list. One of each."""
    lines = text.splitlines()

    def written(k, change):
        values = json.loads(lines[k])
        change(values)
        return [*lines[:k], json.dumps(values, separators=(",", ":")), *lines[k + 1:]]

    def record():
        return rng.randrange(1, len(lines))

    lists = [(key, written(record() if table is RECORD else 0, lambda values: values.update(
        {key: change(values.get(key), rng)}))) for table in (RECORD, HEADER) for key, changes in table.items()
             for change in changes]
    k = record()
    lists += [("missing record", lines[:k] + lines[k + 1:]), ("record twice", lines[:k + 1] + lines[k:])]
    k = rng.randrange(1, len(lines) - 1)
    lists += [("order", [*lines[:k], lines[k + 1], lines[k], *lines[k + 2:]])]
    for where in (0, record()):
        for key in ("limits", "samples", "volume", "hull_volume2"):
            lists.append(("unknown key", written(where, lambda values: values.update({key: [[0], [0]]}))))
        lists.append(("missing key", written(where, lambda values: values.pop(
            rng.choice(sorted({*RECORD, *HEADER}.intersection(values) - {"input_sha256"}))))))
    lists.append(("end", lines[:rng.randrange(len(lines))]))
    return [(what, "".join(line + "\n" for line in forged)) for what, forged in lists]
