"""Every public function of the library stands in every_mode_test.cpp, where it is called in every mode for doubles.

Functions of internal headers may stand there, too.

Usage: public_functions_test.py SOURCES
"""

import pathlib
import re
import sys



def declarations(text):
    """The public names of a header: functions, and members as Class::member."""
    text = re.sub(r"//.*", "", text)
    text = re.sub(r"^#.*", "", text, flags=re.M)
    scope, depth, public = [], 0, [True]
    statement = ""
    for character in text:
        if character == "{":
            head = " ".join(statement.split())
            kind = re.match(r"(?:class|struct|enum class|enum|namespace) ?([\w:]*)", head)
            if kind and "(" not in head:
                scope.append((kind.group(0).split()[0], kind.group(1)))
                public.append(not head.startswith("class"))
            else:
                yield from name_of(head, scope, public)
                scope.append(("body", ""))
                public.append(False)
            statement = ""
        elif character == "}":
            if scope:
                scope.pop()
                public.pop()
            statement = ""
        elif character == ";":
            yield from name_of(" ".join(statement.split()), scope, public)
            statement = ""
        else:
            statement += character
            access = re.search(r"\b(public|private|protected):\s*$", statement)
            if access:
                public[-1] = access.group(1) == "public"
                statement = ""


def name_of(declaration, scope, public):
    if not all(public) or any(kind in ("body", "enum") for kind, _ in scope):
        return
    declaration = re.sub(r"\[\[[^\]]*\]\]", "", declaration)
    if re.match(r"\s*(using|typedef|friend|template|inline constexpr|constexpr|static constexpr)\b", declaration):
        return
    if re.search(r"=\s*(delete|default)\s*$", declaration) or "operator" in declaration or "~" in declaration:
        return
    head = re.match(r"[^=]*?\b([A-Za-z_]\w*)\s*\(", declaration)
    # A move keeps what is there.
    if not head or re.search(r"\(\w+&&\) noexcept$", declaration) or "std::function<" in declaration[: head.end()]:
        return
    classes = [name for kind, name in scope if kind in ("class", "struct")]
    yield "::".join([*classes[-1:], head.group(1)])


def functions(sources, headers):
    names = set()
    for header in (sources / "src").glob(headers):
        names.update(declarations(header.read_text()))
    return names


def tested_functions(sources):
    text = (sources / "tests/unit/every_mode_test.cpp").read_text()
    return set(re.findall(r'"([A-Za-z_]\w*(?:::\w+)?)"', text))


def self_test():
    header = """
namespace flowcert {
class A {
 public:
  A(int n);
  A(A&&) noexcept;
  A(B&&, int) = delete;
  ~A();
  [[nodiscard]] std::vector<double> f(const std::function<void(int)>& g) const { return h(1); }
  bool operator==(const A&) const;
  std::function<void(int)> field = {};
 private:
  void secret();
};
struct B { double x = 0; static B of(int); };
[[nodiscard]] double g(const A& a,
                       int k = f(1));
}
"""
    found = set(declarations(header))
    assert found == {"A::A", "A::f", "B::of", "g"}, found


def main():
    self_test()
    sources = pathlib.Path(sys.argv[1])
    public, tested = functions(sources, "*/include/flowcert/*.h"), tested_functions(sources)
    internal = functions(sources, "*/*.h")
    assert len(public) > 150, f"only {len(public)} public functions were found"
    missing = sorted(public - tested)
    stale = sorted(name for name in tested - public - internal if "::" in name)
    for name in missing:
        print(f"{name} is not called in every mode (tests/unit/every_mode_test.cpp)")
    for name in stale:
        print(f"{name} is no function, and stands in tests/unit/every_mode_test.cpp")
    sys.exit(1 if missing or stale else 0)


if __name__ == "__main__":
    main()
