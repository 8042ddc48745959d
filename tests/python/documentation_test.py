"""What is said of the package is true: docstrings, help(), stubs, the example of its README, and _repr_html_."""

import ast
import doctest
import html.parser
import importlib
import inspect
import pathlib
import pydoc
import re

import flowcert
import numpy as np
import pytest
from conftest import CUBE
from flowcert import _core

ROOT = pathlib.Path(__file__).parents[2]
PACKAGE = pathlib.Path(flowcert.__file__).parent
MODULES = ["flowcert", *(f"flowcert.{path.stem}" for path in sorted(PACKAGE.glob("_[a-z]*.py")))]


@pytest.mark.parametrize("name", MODULES)
def test_examples_in_docstrings(name):
    module = importlib.import_module(name)
    names = {**vars(module), **{public: getattr(flowcert, public) for public in flowcert.__all__}, "flowcert": flowcert}
    results = doctest.testmod(module, extraglobs=names)
    assert results.failed == 0
    if name in ("flowcert", "flowcert._flow_complex", "flowcert._check", "flowcert._generate"):
        assert results.attempted > 0


def public_parts():
    for name in flowcert.__all__:
        if name.startswith("__"):
            continue  # the version, a str
        part = getattr(flowcert, name)
        yield name, part
        if inspect.isclass(part) and not issubclass(part, tuple):
            for member, value in vars(part).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    yield f"{name}.{member}", value


@pytest.mark.parametrize("name, part", public_parts(), ids=lambda part: part if isinstance(part, str) else "")
def test_every_part_has_a_docstring_and_types(name, part):
    text = inspect.getdoc(part)
    assert text and text[0].isupper() or text[0] in "(\"1" or text[:3] == "All", name
    assert max(map(len, text.splitlines())) <= 116  # of 120 columns in the file
    function = part.fget if isinstance(part, property) else part
    if inspect.isfunction(function):
        hints = inspect.signature(function)
        assert hints.return_annotation is not inspect.Signature.empty
        for parameter in list(hints.parameters.values()):
            assert parameter.name == "self" or parameter.annotation is not inspect.Parameter.empty
            assert not isinstance(parameter.default, bool) or parameter.kind == parameter.KEYWORD_ONLY


def test_all_has_all_public_names():
    parts = {name for name, part in vars(flowcert).items() if not (name.startswith("_") or inspect.ismodule(part))}
    assert parts == {name for name in flowcert.__all__ if not name.startswith("_")}


def test_arrays_have_shapes_and_units_in_their_docstrings():
    for cls in (flowcert.Mesh, flowcert.Surfaces, flowcert.Lines):
        for field in cls._fields:
            assert re.search(rf"^\s*{field}\s+\(.*\) (float|int)\d+", cls.__doc__, re.MULTILINE), (cls, field)
    classes = ("Segment", "Limit", "Orbit", "Direction", "LambdaList", "Finding", "CheckReport", "SurfaceCorner",
               "UnstableInterval", "UnstableSheet", "UnstableSegment", "UnstableSurface", "Chamber", "Window",
               "QuadraticNumber")  # fmt: skip
    for cls in (getattr(flowcert, name) for name in classes):
        for field in cls.__dataclass_fields__:
            assert re.search(rf"^\s*([a-z_]+, )?{field}[ ,]", cls.__doc__, re.MULTILINE), (cls, field)
    fields = flowcert.FlowComplex(CUBE).stationary_points.dtype.names
    assert all(re.search(rf"^ *{field} ", flowcert.FlowComplex.stationary_points.__doc__, re.M) for field in fields)
    fields = flowcert.FlowComplex(CUBE).connections.dtype.names
    assert all(re.search(rf"^ *{field} ", flowcert.FlowComplex.connections.__doc__, re.M) for field in fields)
    fields = flowcert.pores(CUBE, 0.5).points.dtype.names
    assert all(re.search(rf"^ *{field} ", flowcert.Pores.points.__doc__, re.M) for field in fields)
    pair_fields = flowcert.FlowComplex(CUBE).persistence_pairs().dtype.names
    assert all(field in flowcert.FlowComplex.persistence_pairs.__doc__ for field in pair_fields)


def test_help_shows_what_there_is():
    text = pydoc.render_doc(flowcert, renderer=pydoc.plaintext)
    for words in ("FlowComplex(points)", "pores(points, radii)", "the square of", "GNU General Public License"):
        assert words in text
    text = pydoc.render_doc(flowcert.FlowComplex, renderer=pydoc.plaintext)
    for words in ("What is copied", "critical_points", "contact_offsets", "index2-radius<R", "GUDHI's form"):
        assert words in text


def stub_of(tree):
    """{name: the names of a function's arguments, or None}, methods as Class.name."""
    found = {}
    for node in tree.body:
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found[node.target.id] = None
        elif isinstance(node, ast.FunctionDef):
            found[node.name] = [argument.arg for argument in node.args.args]
        elif isinstance(node, ast.ClassDef):
            found[node.name] = None
            for name, arguments in stub_of(node).items():
                found[f"{node.name}.{name}"] = arguments
    return found


def test_the_stub_is_that_of_the_extension():
    stub = stub_of(ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8")))
    real = {name for name in vars(_core) if not name.startswith("__")}
    for cls in (_core.Complex, _core.Pores):
        names = (name for name in vars(cls) if not name.startswith("_") or name == "__init__")
        real |= {f"{cls.__name__}.{name}" for name in names}
    assert set(stub) == real
    for name, arguments in stub.items():
        part = _core
        for word in name.split("."):
            part = vars(part)[word] if inspect.isclass(part) else getattr(part, word)
        if arguments and not isinstance(part, property) and part.__doc__:
            # pybind11 says the signature in the first line.
            signature = part.__doc__.splitlines()[0]
            said = re.findall(r"(\w+): ", signature[: signature.rindex("->")])
            assert said == arguments, name
    assert (PACKAGE / "py.typed").exists()


def block_of_readme(name):
    text = (ROOT / "src/python/README.md").read_text(encoding="utf-8")
    found = re.search(rf"^<!-- example: {name} -->\n```\w*\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert found, f"src/python/README.md has no block for {name}"
    return found[1]


def test_the_readmes_example_prints_what_the_readme_says(capsys):
    exec(compile(block_of_readme("python"), "src/python/README.md", "exec"), {})
    assert capsys.readouterr().out == block_of_readme("python output")


class Cells(html.parser.HTMLParser):
    """The texts of the cells, row by row; every tag is closed in its turn."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows = [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1] in ("th", "td"):
            self.rows[-1].append(data)


def test_the_counts_are_a_table_in_notebooks():
    points = np.concatenate([CUBE, CUBE[:1]])
    fc = flowcert.FlowComplex(points)
    assert repr(fc) == "<flowcert.FlowComplex of 9 points>"
    rows = {row[0]: int(row[1].replace(",", "")) for row in Cells(fc._repr_html_()).rows}
    assert rows["points"] == 9 and rows["merged duplicates"] == 1 and rows["Euler sum"] == 1
    assert tuple(rows[f"critical points of index {index}"] for index in range(4)) == fc.counts == (8, 12, 6, 1)
    assert all(rows[f"regular stationary points {a}-{b}"] == n for (a, b), n in fc.regular_counts.items())
