"""What the tests of viewer pages share: the program, pages of named inputs, and one headless Chromium.

Guarantees: pages are made by the program alone (`flowcert view`), each once. A page is opened from disk. After every
test the console is empty but for what the test expects, and nothing but pages themselves was asked for.
"""
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import browser as browsers  # noqa: E402
import computing_page  # noqa: E402
import inputs  # noqa: E402
import program as programs  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pytest_addoption(parser):
    parser.addoption("--flowcert", default=str(ROOT / "build" / "flowcert"), help="the program")
    parser.addoption("--computing", default=str(ROOT / "build-wasm" / "flowcert.html"),
                     help="the page that computes")
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


@pytest.fixture(scope="session")
def computing(request):
    """The page as bytes."""
    path = request.config.getoption("--computing")
    if not pathlib.Path(path).is_file():
        pytest.skip(f"{path} is not there; ./dev wasm makes it")
    return pathlib.Path(path).read_bytes()


@pytest.fixture(scope="session")
def server(computing):
    with computing_page.Server(computing) as served:
        yield served


@pytest.fixture
def unread_page(chromium, server, tmp_path):
    """The page, opened; its messages and requests are for the test to look at."""
    chromium.driver.execute_cdp_cmd("Browser.setDownloadBehavior",
                                    {"behavior": "allow", "downloadPath": str(tmp_path)})
    chromium.forget()
    server.asked.clear()
    page = computing_page.ComputingPage(chromium, tmp_path)
    page.open(server.address)
    yield page
    chromium.driver.get("about:blank")
    chromium.forget()


@pytest.fixture
def page(unread_page, server):
    yield unread_page
    assert unread_page.browser.messages() == []
    assert unread_page.browser.requests() == [server.address]
    assert server.asked == ["/"]
