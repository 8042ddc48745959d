"""Every link, anchor and picture of every page, and what the pages must have: clauses, commands, names of Python."""
import re
import subprocess
import urllib.parse

from conftest import PHONE, ROOT

MOST = 10_000_000


def test_links_lead_to_files_and_anchors(site, seen):
    wrong, count = [], 0
    for page, looked in seen.items():
        for link in looked.links:
            address, fragment = urllib.parse.urldefrag(link)
            if not address.startswith("file:"):
                assert re.match(r"https?:|mailto:", address), f"{page}: {link}"
                continue
            count += 1
            path = urllib.parse.unquote(urllib.parse.urlsplit(address).path)
            name = path.removeprefix(f"{site}/")
            target = seen.get(name)
            if not path.startswith(f"{site}/") or not (site / name).is_file():
                wrong.append(f"{page}: {link}")
            elif fragment and target and urllib.parse.unquote(fragment) not in target.ids:
                wrong.append(f"{page}: {link} has no such anchor")
    assert count > 5000
    assert wrong == []


def test_pictures_are_there(seen):
    assert [f"{page}: {picture}" for page, looked in seen.items() for picture in looked.broken] == []


def test_no_page_asks_for_anything_elsewhere(seen):
    assert {page: looked.asked for page, looked in seen.items() if looked.asked} == {}
    assert {page: looked.messages for page, looked in seen.items() if looked.messages} == {}


def test_pages_have_one_heading_and_ids_once(seen):
    # The theme's own page of the search has no heading on Debian 12.
    assert [page for page, looked in seen.items() if looked.headings != 1 and page != "search.html"] == []
    twice = {page: sorted({each for each in looked.ids if looked.ids.count(each) > 1}) for page, looked in seen.items()}
    assert {page: ids for page, ids in twice.items() if ids} == {}


def test_no_page_is_wider_than_a_phone(seen):
    assert [page for page, looked in seen.items() if looked.width > PHONE] == []
    assert {page: looked.wide for page, looked in seen.items() if looked.wide} == {}


def test_every_clause_has_its_anchor(seen):
    count = 0
    for path in sorted((ROOT / "spec").rglob("*.md")):
        page = str(path.relative_to(ROOT).with_suffix(".html"))
        for clause in re.findall(r"^\*\*(FC-[A-Z]+-\d\d)\*\*", path.read_text(encoding="utf-8"), flags=re.MULTILINE):
            assert clause in seen[page].ids, f"{page}: {clause}"
            count += 1
    assert count > 200


def test_every_command_has_its_page(build, seen):
    told = subprocess.run([build / "flowcert", "--help"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  ([a-z]+)  ", told, flags=re.MULTILINE)
    assert len(names) >= 13
    assert [name for name in names if f"commands/flowcert-{name}.html" not in seen] == []


def test_every_name_of_python_has_its_anchor(build, seen):
    program = "import flowcert; print(*(name for name in flowcert.__all__ if not name.startswith('_')))"
    told = subprocess.run(["/usr/bin/python3", "-B", "-c", program], capture_output=True, text=True, check=True,
                          env={"PYTHONPATH": str(build / "python")}).stdout
    names = told.split()
    assert len(names) > 20
    assert [name for name in names if f"flowcert.{name}" not in seen["python.html"].ids] == []


def test_size(site):
    sizes = [path.stat().st_size for path in site.rglob("*") if path.is_file() and site / "cpp" not in path.parents]
    assert sum(sizes) <= MOST
