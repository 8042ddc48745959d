"""What the tests of viewer pages share: the program, pages of named inputs, and one headless Chromium.

Guarantees: pages are made by the program alone (`flowcert view`), each once. A page is opened from disk. After every
test the console is empty but for what the test expects, and nothing but pages themselves was asked for.
"""
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import browser as browsers  # noqa: E402
import inputs  # noqa: E402
import program as programs  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pytest_addoption(parser):
    parser.addoption("--flowcert", default=str(ROOT / "build" / "flowcert"), help="the program")
    parser.addoption("--factor", type=float, default=1.0, help="times may be so many times longer, on a busy machine")


@pytest.fixture(scope="session")
def factor(request):
    return request.config.getoption("--factor")


@pytest.fixture(scope="session")
def program(request, tmp_path_factory):
    return programs.Program(request.config.getoption("--flowcert"), tmp_path_factory.mktemp("program"))


@pytest.fixture(scope="session")
def made(program):
    """made(name): the page of an input of inputs.py."""
    return lambda name: program.page(name, inputs.text(name))


@pytest.fixture(scope="session")
def chromium():
    with browsers.Browser() as browser:
        yield browser


@pytest.fixture
def browser(chromium):
    chromium.forget()
    yield chromium
    assert chromium.messages() == []
    assert chromium.requests() == []


@pytest.fixture
def opened(browser, made):
    """opened(name, hash): the page of an input, opened and ready."""

    def open_page(name, fragment=""):
        page = made(name)
        browser.open(page.path, fragment)
        return page

    return open_page
