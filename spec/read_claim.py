"""Reads claims for judge.py: the exchange format, CSV and the format of Giesen and Kühne (formats/claims.md).

Numbers are exact: fractions, never doubles. What cannot be read is Unreadable, with the reason (FC-CLAIM-20).
Of the exchange format every line is as schemas/exchange.schema.json says, what level 5 is about, too.
"""
import functools, gzip, io, itertools, json, re, zlib
from collections import namedtuple
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

BLANKS = " \t\v\f"
KINDS = [(1, 2), (1, 3), (2, 3)]


class Unreadable(Exception):
    """A claim that means nothing. The message says why."""


def require(condition, message):
    if not condition:
        raise Unreadable(message)


# ---- Numbers (FC-FILE-18, 47). A number is a pair: its value, and whether it is claimed exactly.


def hexadecimal(text):
    parts = re.fullmatch(r"([+-]?)0[xX]([0-9a-fA-F]*)\.?([0-9a-fA-F]*)(?:[pP]([+-]?[0-9]+))?", text)
    require(parts and parts[2] + parts[3], f"not a number: {text[:40]}")
    mantissa, power = int(parts[2] + parts[3], 16), int(parts[4] or 0) - 4 * len(parts[3])
    zeros = (mantissa & -mantissa).bit_length() - 1
    bits = mantissa.bit_length() - zeros
    is_double = bits <= 53 and power + zeros >= -1074 and bits + zeros + power <= 1024
    require(is_double or not mantissa, f"not a double: {text[:40]}")
    value = (mantissa >> zeros) * Fraction(2) ** (power + zeros) if mantissa else Fraction(0)
    return -value if parts[1] == "-" else value


def number(text, plain_is_exact=False):
    require(len(text) <= 1000000, f"too long: {text[:40]}")
    if re.match(r"[+-]?0[xX]", text):
        return hexadecimal(text), True
    if parts := re.fullmatch(r"([+-]?[0-9]+)/([0-9]+)", text):
        require(int(parts[2]), f"the denominator is zero: {text[:40]}")
        return Fraction(int(parts[1]), int(parts[2])), True
    parts = re.fullmatch(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]+))?", text)
    require(parts, f"not a number: {text[:40]}")
    exact = plain_is_exact and re.fullmatch(r"[+-]?[0-9]+", text) is not None
    require(exact or (len(text) <= 2000 and abs(int(parts[1] or 0)) <= 700), f"too long: {text[:40]}")
    return Fraction(text), exact


def nearest_double(value):
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return None


def rounds_alike(a, b):
    return nearest_double(a) is not None and nearest_double(a) == nearest_double(b)


def roots_differ_by(a, b, squared_length):
    """Whether the roots of a and b differ by no more than a length: d^2 + r^2 - t^2 <= 2 d r."""
    left = a + b - squared_length
    return left <= 0 or left * left <= 4 * a * b


# ---- JSON, and the schema of a line of the exchange format

Literal = namedtuple("Literal", "text")  # a number as it is written, so that it equals no string


class Whole(Literal):
    """One without point and exponent."""


def literal(text):
    require(abs(float(text)) < float("inf"), f"out of range of a double: {text[:40]}")
    return (Whole if re.fullmatch("-?[0-9]+", text) else Literal)("0" if text == "-0" else text)


def object_of(pairs):
    require(len(pairs) <= 1000 and len(dict(pairs)) == len(pairs), "a key twice, or more than 1,000 keys")
    return dict(pairs)


def parse(text):
    brackets = re.findall(r"[][{}]", re.sub(r'"(\\.|[^"\\])*"', "", text))
    depths = itertools.accumulate(1 if one in "[{" else -1 for one in brackets)
    require(max(depths, default=0) <= 16, "nested deeper than 16 levels")
    try:
        value = json.loads(text, object_pairs_hook=object_of, parse_int=literal, parse_float=literal,
                           parse_constant=lambda word: require(False, "not JSON"))
        if "\\u" in text:  # half a surrogate pair has no UTF-8
            json.dumps(value, ensure_ascii=False, default=str).encode()
    except (json.JSONDecodeError, UnicodeEncodeError) as error:
        raise Unreadable(f"not JSON: {error}") from error
    require(isinstance(value, dict), "not an object")
    return value


SCHEMA = parse((Path(__file__).parent / "schemas" / "exchange.schema.json").read_text())
RECORD, HEADER, INFINITY = (SCHEMA["definitions"][name] for name in ("record", "header", "infinity"))
TYPES = {"object": dict, "array": list, "number": Literal, "integer": Whole, "boolean": bool, "string": str,
         "null": type(None)}
# As much of JSON Schema (draft 7) as the schema of a line needs: of what types a value has to be for a rule to speak of
# it, and the rule. It takes a value, its own part of a schema, and the schema.
RULES = {
    "$ref": (object, lambda value, path, _: fits_definition(value, path)),
    "type": (object, lambda value, names, _: isinstance(value, tuple(
        TYPES[one] for one in ([names] if isinstance(names, str) else names)))),
    "const": (object, lambda value, one, _: value == one),
    "enum": (object, lambda value, some, _: value in some),
    "minimum": (Literal, lambda value, least, _: Fraction(value.text) >= Fraction(least.text)),
    "maximum": (Literal, lambda value, most, _: Fraction(value.text) <= Fraction(most.text)),
    "pattern": (str, lambda value, pattern, _: re.search(pattern, value)),
    "minItems": (list, lambda value, least, _: len(value) >= int(least.text)),
    "maxItems": (list, lambda value, most, _: len(value) <= int(most.text)),
    "uniqueItems": (list, lambda value, *_: len(set(value)) == len(value)),
    "items": (list, lambda value, items, _: all(
        map(fits, value, items if isinstance(items, list) else itertools.repeat(items)))),
    "required": (dict, lambda value, keys, _: all(key in value for key in keys)),
    "properties": (dict, lambda value, known, _: all(fits(value[key], known[key]) for key in known if key in value)),
    "allOf": (object, lambda value, some, _: all(fits(value, one) for one in some)),
    "anyOf": (object, lambda value, some, _: any(fits(value, one) for one in some)),
    "not": (object, lambda value, one, _: not fits(value, one)),
    "if": (object, lambda value, test, schema: fits(value, schema.get("then" if fits(value, test) else "else", True)))}


def fits(value, schema):
    return schema is True or (schema is not False and all(
        rule(value, schema[key], schema) for key, (types, rule) in RULES.items()
        if key in schema and isinstance(value, types)))


def fits_definition(value, path):
    *_, name = names = path.split("/")[1:]
    if not fits(value, functools.reduce(dict.get, names, SCHEMA)):
        return False
    require(name != "vector" or any(json_number(one)[0] for one in value), "a vector that is zero")
    return name != "rational" or json_number(value) is not None  # or raises what is wrong with it


# ---- Claims, read. `hull` is the second part of a kind, and None for a critical point. A target None is infinity.


def count_of(value):
    require(isinstance(value, Literal) and re.fullmatch("[0-9]+", value.text), f"not a whole number: {value}")
    require(int(value.text) < 2**64, f"too large: {value}")
    return int(value.text)


def ids(values):
    found = [count_of(one) for one in values]
    require(all(one <= 2147483646 for one in found), "an id beyond 2147483646")
    return found


def json_number(value, least=None):
    found = number(value.text) if isinstance(value, Literal) else number(value, plain_is_exact=True)
    require(least is None or found[0] >= least, f"less than {least}: {value}")
    return found


def blank_point(line, index, contact, hull=None):
    return SimpleNamespace(line=line, index=index, hull=hull, contact=contact, center=None, squared=None, distance=None,
                           doubles=[], squared_double="none", targets=None, by_side=False, samples=None, boundary=None,
                           lists=[])


def lists_in(value, key=""):
    """The lists of rows in what a line says."""
    if key in ("shares", "shares_double"):
        return [ids(one[0] for one in value)]
    if key == "walk":
        return [[one] for one in ids(value or [])]
    if isinstance(value, list) and all(isinstance(one, Literal) for one in value):
        is_of_rows = key in ("contact", "polygon", "samples", "front_contact", "back_contact", "limit", "to", "set")
        return [ids(value)] if is_of_rows else []
    if isinstance(value, dict):
        return [found for name, one in value.items() for found in lists_in(one, name)]
    inner = "set" if key in ("limits", "boundary", "arcs") else ""
    return [found for one in value for found in lists_in(one, inner)] if isinstance(value, list) else []


def exchange_point(record, line):
    index, hull = record["index"] if isinstance(record["index"], list) else (record["index"], None)
    point = blank_point(line, int(index.text), ids(record.get("contact", [])), hull and int(hull.text))
    doubles = [None if one is None else json_number(one) for one in record.get("center_double") or []]
    if "center" in record:
        point.center, point.doubles = [json_number(one) for one in record["center"]], doubles
    elif None not in doubles:
        point.center = doubles or None
    require(point.contact or point.center, "neither 'contact' nor 'center'")
    squared, near = (None if record.get(key) is None else json_number(record[key], least=0)
                     for key in ("squared_distance", "squared_distance_double"))
    point.squared = squared or near
    if squared and "squared_distance_double" in record:
        point.squared_double = near
    point.samples = ids(record.pop("samples")) if "samples" in record else None
    if "limits" in record:
        point.targets, point.by_side = [None if one is None else ids(one) for one in record["limits"]], True
    if "boundary" in record.get("stable", {}):
        point.boundary = [ids(one) for one in record["stable"]["boundary"]]
    point.lists = lists_in({key: one for key, one in record.items() if key in RECORD["properties"]})
    return point


def read_header(line):
    require(fits(line, HEADER), "a header that is not as its schema says")
    read = {"points": count_of, "merged_duplicates": count_of, "input_sha256": str,
            "classes": lambda lists: list(map(ids, lists)), "critical": lambda counts: list(map(count_of, counts)),
            "regular_stationary": lambda counts: [count_of(counts[f"{i}-{j}"]) for i, j in KINDS]}
    head = {key: reader(line[key]) for key, reader in read.items() if key in line}
    indices = {int(one.text) for one in line["indices"]} if "indices" in line else {0, 1, 2, 3}
    return SimpleNamespace(points=[], infinity=[], indices=indices, head=head)


def read_exchange(lines):
    filled = [(k, parse(line)) for k, line in enumerate(lines, 1) if line.strip(BLANKS)]
    claim = read_header(filled[0][1])
    for k, record in filled[1:]:
        is_infinity = record.get("kind") == "infinity"
        require(fits(record, INFINITY if is_infinity else RECORD), f"line {k} is not as its schema says")
        if is_infinity:
            require(not claim.infinity, "a second line of infinity")
            claim.infinity = [[], *lists_in(record["skeleton"])]
        else:
            claim.points.append(exchange_point(record, k))
    return claim


# ---- Claims in lines of text (FC-FILE-15, 16, 47)


def without_comment(line):
    return re.split(r"(?<!\.)#", line)[0].strip(BLANKS)


def read_csv(lines):
    points, names = [], ["index", "x", "y", "z", "squared_distance"]
    filled = [(k, text) for k, line in enumerate(lines, 1) if (text := without_comment(line))]
    for k, text in filled:
        fields = re.split(f"[{BLANKS}]*,[{BLANKS}]*|[{BLANKS}]+", text)
        while len(fields) > 4 and not fields[-1]:
            fields.pop()
        if k == filled[0][0] and fields[0] == "index":
            require(len(fields) >= 4 and fields[:5] == names[:len(fields)], f"other columns than {', '.join(names)}")
            continue
        require(len(fields) >= 4 and re.fullmatch("[0-3]", fields[0]), "no index, 0 to 3, or too few numbers after it")
        point = blank_point(k, int(fields[0]), ids(map(Literal, fields[5:])))
        point.center = [number(one) for one in fields[1:4]] if any(fields[1:4]) else None
        point.squared = json_number(Literal(fields[4]), least=0) if len(fields) > 4 and fields[4] else None
        require(point.center or point.contact, "neither a position nor contact ids")
        points.append(point)
    return points


def read_bars(lines):
    points, infinities = [], 0
    for k, line in enumerate(lines, 1):
        parts = [[one for one in re.split(f"[{BLANKS}]+", part) if one] for part in line.split("|")]
        if parts[0][:1] == ["inf"]:
            require(parts == [["inf", "3"]] and not infinities, "not one maximum at infinity in dimension 3")
            infinities = 1
        elif line.strip(BLANKS):
            parts = parts if parts[-1] else parts[:-1]
            require(len(parts) > 1 and len(parts[1]) == 1, "no distance")
            sets = [None if one == ["inf"] else ids(map(Literal, one)) for one in [parts[0], *parts[2:]]]
            require(all(one is None or 1 <= len(one) <= 4 for one in sets), "a point, or a successor, of no ids")
            point = blank_point(k, len(sets[0]) - 1, sets[0])
            point.distance, point.targets = json_number(Literal(parts[1][0]), least=0), sets[1:]
            point.lists = list(filter(None, sets))
            points.append(point)
    return points


def decompressed(data):
    if data[:2] != b"\x1f\x8b":
        return data
    most = min(max(100 * len(data), 1 << 20), 4 << 30)
    try:
        found = gzip.GzipFile(fileobj=io.BytesIO(data)).read(most + 1)
    except (OSError, EOFError, zlib.error) as error:
        raise Unreadable(f"damaged: {error}") from error
    require(len(found) <= most, "it grows to more than a hundred times its size")
    return found


def read_claim(data, rows):
    """The claim in some bytes, about so many rows."""
    require(data is not None, "there is no answer, or one that is too large")
    data = decompressed(data).removeprefix(b"\xef\xbb\xbf")
    start = data.strip((BLANKS + "\r\n").encode())[:1]
    require(start, "an empty file")
    require(start != b"<", "VTP is not read here")
    try:
        lines = re.split("\r\n|\r|\n", data.decode(errors="strict" if start == b"{" else "replace"))
    except UnicodeDecodeError as error:
        raise Unreadable(f"not UTF-8: {error}") from error
    if start == b"{":
        claim = read_exchange(lines)
    else:
        first = next(filter(None, map(without_comment, lines)), "")
        read = read_bars if re.match(f"inf([{BLANKS}]|$)|.*[|]", first) else read_csv
        claim = SimpleNamespace(points=read(lines), infinity=[], indices={0, 1, 2, 3}, head={})
    lists = [some for point in claim.points for some in [point.contact, point.samples or [], *point.lists]]
    require(all(one < rows for some in lists + claim.infinity for one in some), "there is no such point")
    return claim
