"""What the tests of the site share: the site as ./dev site has made it, one Chromium, and what it saw of every page.

Guarantees: pages are opened from disk. After every test the console is empty, and nothing but files of the site was
asked for. Nothing here knows how the site is made.
"""
import dataclasses
import pathlib
import sys
from typing import Dict, List

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "web"))

PHONE = 390
# What others have made: the reference of C++, the live bunny, and the page that computes, each with its own tests.
FOREIGN = ("cpp/", "bunny.html", "flowcert.html")
LOOK = """
// Beyond the window, and in nothing that scrolls by itself, such as a table.
const sticks_out = (element) => {
  if (element.getBoundingClientRect().right <= innerWidth + 1) return false;
  for (let above = element.parentElement; above.tagName !== 'ARTICLE'; above = above.parentElement)
    if (['auto', 'scroll'].includes(getComputedStyle(above).overflowX)) return false;
  return !['auto', 'scroll'].includes(getComputedStyle(element).overflowX) || element.offsetWidth > innerWidth;
};
return {
  links: [...document.links].map((link) => link.href),
  ids: [...document.querySelectorAll('[id]')].map((element) => element.id),
  broken: [...document.images].filter((image) => !image.naturalWidth).map((image) => image.src),
  headings: document.querySelectorAll('h1').length,
  width: document.documentElement.scrollWidth,
  wide: [...document.querySelectorAll('article *')].filter(sticks_out).slice(0, 3).map(
    (element) => element.outerHTML.slice(0, 200)),
};
"""


def pytest_addoption(parser):
    parser.addoption("--build", default=str(ROOT / "build"), help="the build, with its site")
    parser.addoption("--factor", type=float, default=1.0, help="times may be so many times longer, on a busy machine")


@dataclasses.dataclass
class Seen:
    """A page, in a window as wide as a phone."""

    links: List[str]
    ids: List[str]
    broken: List[str]
    headings: int
    width: int
    wide: List[str]
    messages: List[str]
    asked: List[str]


@pytest.fixture(scope="session")
def factor(request):
    return request.config.getoption("--factor")


@pytest.fixture(scope="session")
def build(request):
    return pathlib.Path(request.config.getoption("--build")).resolve()


@pytest.fixture(scope="session")
def site(build):
    if not (build / "site/index.html").is_file():
        pytest.skip(f"{build}/site/index.html is not there; ./dev site makes it")
    return build / "site"


@pytest.fixture(scope="session")
def pages(site):
    """{name: path} of all pages that are the site's own."""
    names = {str(path.relative_to(site)): path for path in sorted(site.rglob("*.html"))}
    return {name: path for name, path in names.items() if not name.startswith(FOREIGN)}


@pytest.fixture(scope="session")
def chromium():
    pytest.importorskip("selenium", reason="there is no selenium")
    import browser as browsers

    if not pathlib.Path("/usr/bin/chromium").is_file() or not pathlib.Path(browsers.DRIVER).is_file():
        pytest.skip("there is no Chromium with its driver")
    with browsers.Browser() as browser:
        yield browser


def asked_elsewhere(browser, site):
    inside = site.as_uri() + "/"
    return [address for address in browser.requests() if not address.startswith(inside)]


@pytest.fixture
def browser(chromium, site):
    set_width(chromium, 1400)
    chromium.forget()
    yield chromium
    assert chromium.messages() == []
    assert asked_elsewhere(chromium, site) == []


def set_width(browser, width):
    browser.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                   {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})


@pytest.fixture(scope="session")
def seen(chromium, site, pages) -> Dict[str, Seen]:
    """Every page, opened once."""
    set_width(chromium, PHONE)
    chromium.forget()
    found = {}
    for name, path in pages.items():
        chromium.driver.get(path.as_uri())
        found[name] = Seen(**chromium.run(LOOK), messages=chromium.messages(), asked=asked_elsewhere(chromium, site))
    return found
