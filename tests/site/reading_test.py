"""A reader in Chromium: the bunny is there at once, the search finds, and a mouse is not needed."""
import time
import urllib.parse

import pytest

pytest.importorskip("selenium", reason="there is no selenium")
from selenium.webdriver.common.keys import Keys  # noqa: E402

from browser import WAIT  # noqa: E402
from computing_page import Server  # noqa: E402
from conftest import PHONE, set_width  # noqa: E402
from policy_test import DOCUMENT, IN_DOCUMENT  # noqa: E402

# Whether the scene has drawn: its canvas has pixels of more than a few colours.
DRAWN = """
const canvas = document.getElementById('scene'), copy = document.createElement('canvas');
flowcert.redraw_now();
Object.assign(copy, {width: canvas.width, height: canvas.height});
const context = copy.getContext('2d', {willReadFrequently: true});
context.drawImage(canvas, 0, 0);
return new Set(new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
"""
FOCUSED = """
const it = document.activeElement;
return {tag: it.tagName, href: it.href || '', name: it.name || '', text: it.textContent.trim().slice(0, 80),
        label: it.getAttribute('for') || '', outline: getComputedStyle(it).outlineStyle};
"""


def is_clear(browser, seconds, condition):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, browser.driver.current_url
        time.sleep(0.02)


def tab_to(browser, wanted, most=200):
    """Presses Tab until wanted(element) holds, and returns what had the focus on the way."""
    passed = []
    for _ in range(most):
        browser.keys(Keys.TAB)
        passed.append(browser.run(FOCUSED))
        if wanted(passed[-1]):
            return passed
    raise AssertionError([each["text"] for each in passed])


def test_the_bunny_is_there_at_once(browser, site, factor):
    browser.driver.get("about:blank")
    begin = time.monotonic()
    browser.driver.get((site / "index.html").as_uri())
    browser.driver.switch_to.frame(browser.find("iframe.live"))
    browser.driver.execute_async_script(WAIT)
    browser.rest()
    seconds = time.monotonic() - begin
    colors = browser.run(DRAWN)
    browser.driver.switch_to.default_content()
    print(f"the bunny is there after {seconds:.2f} s")
    assert colors > 100
    assert seconds <= 2 * factor


def results(browser, site, words, factor):
    browser.driver.get((site / "search.html").as_uri() + "?" + urllib.parse.urlencode({"q": words}))
    is_clear(browser, 10 * factor, lambda: browser.find_all("#search-results ul.search li a"))
    time.sleep(0.3)
    found = [link.get_attribute("href") for link in browser.find_all("#search-results ul.search li a")]
    return [urllib.parse.urlsplit(address).path.removeprefix(f"{site}/") for address in found], found


@pytest.mark.parametrize("words, page", [
    ("FC-IN-03", "spec/flow_complex.html"), ("persistence pairs", "spec/formats/persistence.html"),
    ("QuadraticNumber", "python.html"), ("--skip-invalid", "commands/flowcert-compute.html")])
def test_the_search_finds(browser, site, factor, words, page):
    names, addresses = results(browser, site, words, factor)
    assert page in names
    if words.startswith("FC-"):
        assert addresses[0].split("?")[0].endswith(f"{page}#{words}")


def test_the_search_by_keyboard(browser, site, factor):
    browser.driver.get((site / "spec/README.html").as_uri())
    tab_to(browser, lambda it: it["name"] == "q")
    browser.keys("tunnels", Keys.ENTER)
    is_clear(browser, 10 * factor, lambda: "search.html" in browser.driver.current_url)
    is_clear(browser, 10 * factor, lambda: browser.find_all("#search-results ul.search li a"))
    first = browser.find("#search-results ul.search li a").get_attribute("href")
    tab_to(browser, lambda it: it["href"] == first)
    browser.keys(Keys.ENTER)
    is_clear(browser, 10 * factor, lambda: "search.html" not in browser.driver.current_url)


def test_tab_goes_through_the_bunny(browser, site):
    """Into the frame and out of it again, to the links below; each has a visible focus."""
    browser.driver.get((site / "index.html").as_uri())
    browser.run("document.querySelector('iframe.live').focus()")
    passed = tab_to(browser, lambda it: it["href"].endswith("/scaling.html"))
    links = [it for it in passed if it["tag"] == "A"]
    assert any(it["href"].endswith("/bunny.html") for it in links)
    assert all(it["outline"] != "none" for it in links)


def test_the_menu_of_a_phone_by_keyboard(browser, site):
    set_width(browser, PHONE)
    browser.driver.get((site / "spec/README.html").as_uri())
    tab_to(browser, lambda it: it["label"] == "__navigation")
    assert not browser.run("return document.getElementById('__navigation').checked")
    browser.keys(Keys.ENTER)
    assert browser.run("return document.getElementById('__navigation').checked")
    tab_to(browser, lambda it: it["href"].endswith("/spec/claims.html"))
    browser.keys(Keys.ESCAPE)
    assert not browser.run("return document.getElementById('__navigation').checked")


def test_the_first_tab_skips_the_menu(browser, site):
    browser.driver.get((site / "spec/README.html").as_uri())
    browser.keys(Keys.TAB)
    assert "#" in browser.run(FOCUSED)["href"]
    browser.keys(Keys.ENTER)
    passed = tab_to(browser, lambda it: it["tag"] == "A")
    assert browser.run("return document.querySelector('article').contains(document.activeElement)"), passed


def test_the_policy_blocks_all_requests(chromium, site):
    set_width(chromium, 1400)
    chromium.driver.get((site / "spec/README.html").as_uri())
    with Server(b"") as host:
        seen = chromium.driver.execute_async_script(DOCUMENT, host.address)
        assert host.asked == []
    # Chromium may tell of an object only after the script has looked.
    assert {f"/{way}" for way in IN_DOCUMENT - {"object"}} <= set(seen)
    chromium.driver.get("about:blank")
    chromium.forget()
