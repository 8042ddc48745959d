"""Pages with a claim: findings by group, at their places, with the spheres that prove them. Texts stay texts."""
import json

import pytest

HOSTILE = "<script>window.hit = 1</script></script><img src=x onerror=window.hit=1>&amp;&lt;"


def records(page):
    text = page.program.run("compute", page.source, "--manifolds", "u2", "-o", "-")
    header, *lines = map(json.loads, text.splitlines())
    return header, lines


def false_claim(page):
    """A claim with a missing, an extra, a wrongly placed and a wrongly indexed point, and with wrong limits."""
    header, lines = records(page)
    saddles = [r for r in lines if r["index"] == 1]
    discs = [r for r in lines if r["index"] == 2]
    for record in lines:
        record.pop("samples", None)
    lines.remove(saddles[0])
    saddles[1]["center"][0] = "1/7"
    for key in ("center_double", "squared_distance_double"):
        saddles[1].pop(key)
    discs[0]["index"] = 1
    discs[0].pop("limits")
    changed = next(r for r in discs[1:] if r["limits"] != [discs[0]["contact"], None])
    changed["limits"] = [[0, 1, 2, 3], [0, 1, 2, 3]]
    lines.append({"index": 2, "kind": "critical", "contact": [0, 1, 4]})
    return "\n".join(json.dumps(x) for x in [header, *lines]) + "\n"


@pytest.fixture(scope="module")
def claimed(program, made):
    page = made("pyramid")
    claim = program.folder / "claim.jsonl"
    claim.write_text(false_claim(page))
    path = program.folder / "claimed.html"
    program.run("view", page.source, "-o", path, "--claim", claim, statuses=(1,))
    checked = json.loads(program.run("check", page.source, claim, "--json", statuses=(1,)))
    return page, path, checked


def open_claim(browser, claimed):
    page, path, checked = claimed
    browser.open(path)
    return page, checked


def test_findings_are_those_of_check(browser, claimed):
    _, checked = open_claim(browser, claimed)
    groups = browser.ask("finding_groups")
    assert len(groups) == len(checked["findings"])
    assert {"missed", "extra", "wrong index", "wrong position", "wrong limits"} <= set(groups)
    items = browser.find_all("#page-findings .finding")
    assert len(items) == len(groups)
    assert f"verdict: {checked['verdict']}" in browser.find("#page-findings").text


def by_reason(browser, reason):
    browser.run("document.querySelectorAll('#page-findings details').forEach(d => d.open = true)")
    return next(item for item in browser.find_all("#page-findings .finding") if item.text.startswith(reason))


@pytest.mark.parametrize("reason", ["missing", "ball-not-empty", "wrong-index", "wrong-position", "wrong-incidence"])
def test_a_finding_is_shown_in_its_place(browser, claimed, reason):
    page, checked = open_claim(browser, claimed)
    before = browser.ask("camera")
    by_reason(browser, reason).click()
    browser.rest()
    finding = next(f for f in checked["findings"] if f["reason"] == reason)
    assert browser.ask("claim_marks") > 0
    assert browser.ask("camera") != before
    facts = browser.find("#page-findings .finding-facts").text
    assert finding["clause"] in facts and "claimed" in facts and "truth" in facts
    told = [f for f in checked["findings"] if f["reason"] == reason]
    assert any(f["claimed"] in facts and f["truth"] in facts for f in told)
    assert any(f["sentence"] in facts for f in told) and "flowcert explain " in facts
    assert reason == "missing" or any(f"{f['line']} of the claim" in facts for f in told)


def test_samples_inside_a_claimed_sphere_are_named(browser, claimed):
    open_claim(browser, claimed)
    by_reason(browser, "ball-not-empty").click()
    assert "row 5 inside the claimed sphere" in browser.find(".finding-facts").text.replace("\n", " ")


def test_what_is_claimed_is_seen_on_what_is_true(browser, claimed):
    """A wrong index has the true sphere: its lines are dashed, and in the gaps the true ones are seen."""
    open_claim(browser, claimed)
    for layer in browser.ask("layers"):
        browser.ask("set_layer", layer, False)
    colors = ("claimed", "truth")
    assert [browser.count_of_color(color) for color in colors] == [0, 0]
    by_reason(browser, "wrong-index").click()
    browser.rest()
    spheres = browser.run("return JSON.parse(document.getElementById('flowcert-data').textContent)"
                          ".claim.findings.find(f => f.reason === 'wrong-index').spheres")
    assert {sphere["role"] for sphere in spheres} == {"claimed", "true"}
    assert spheres[0]["center"] == spheres[1]["center"] and spheres[0]["radius"] == spheres[1]["radius"]
    for color in colors:
        assert browser.count_of_color(color) > 1200, color


def test_escape_lets_go_of_a_finding(browser, claimed):
    open_claim(browser, claimed)
    by_reason(browser, "missing").click()
    browser.keys("\ue00c")
    assert browser.ask("claim_marks") == 0
    assert browser.find(".finding-facts").text == ""


def test_findings_leave_nothing_on_the_gpu(browser, claimed):
    open_claim(browser, claimed)
    browser.rest()
    counts = []
    for _ in range(2):
        for i in range(len(browser.ask("finding_groups"))):
            browser.ask("finding", i)
            browser.ask("redraw_now")
        counts.append(browser.ask("geometries"))
        browser.keys("\ue00c")
        browser.ask("redraw_now")
        counts.append(browser.ask("geometries"))
    assert counts[:2] == counts[2:] and counts[0] > counts[1]


def test_a_right_claim_has_no_finding(browser, program, made):
    page = made("cube")
    claim, path = program.folder / "right.jsonl", program.folder / "right.html"
    program.run("compute", page.source, "-o", claim)
    program.run("view", page.source, "-o", path, "--claim", claim)
    browser.open(path)
    assert "Nothing is wrong with this claim." in browser.find("#page-findings").text


def test_names_and_texts_are_never_markup(browser, program, made):
    """The names of the input and of the claim, and texts of findings, with all that could end a script."""
    page = made("pyramid")
    name = HOSTILE.replace("/", "\u2044")  # a file name has no slash
    source, claim, path = (program.folder / f"{name}{end}" for end in (".xyz", ".jsonl", ".html"))
    source.write_text(page.source.read_text())
    claim.write_text(false_claim(page))
    program.run("view", source, "-o", path, "--claim", claim, statuses=(1,))
    browser.open(path)
    assert browser.find("#name").text == f"{name}.xyz"
    assert browser.driver.title.startswith(f"{name}.xyz")
    assert name in browser.find("#page-findings h3").text
    assert browser.run("return window.hit") is None
    assert browser.find_all("img") == []


def test_names_that_end_a_script_stay_names(browser, program, made):
    """A name is not always that of a file: the data of a page are changed by hand, as the program writes them."""
    page = made("pyramid")
    text = page.path.read_text()
    name = json.dumps(page.data["name"])
    assert text.count(f'"name":{name}') == 1
    written = json.dumps(HOSTILE).replace("<", "\\u003c")
    path = program.folder / "hostile.html"
    path.write_text(text.replace(f'"name":{name}', f'"name":{written}'))
    browser.open(path)
    assert browser.find("#name").text == HOSTILE
    assert browser.run("return window.hit") is None
    assert browser.find_all("img") == []
