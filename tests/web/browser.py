"""A headless Chromium that draws in software, with what the tests of pages ask of it.

Guarantees: `messages` are those of the console, `requests` are all addresses that were asked for but files of pages,
data: and blob:, as the browser's own log of its network tells.
"""
import json
import pathlib
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.mouse_button import MouseButton
from selenium.webdriver.common.by import By

DRIVER = "/usr/bin/chromedriver"
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--hide-scrollbars", "--force-device-scale-factor=1", "--disable-extensions",
         "--disable-background-networking", "--no-first-run"]
WAIT = """
const done = arguments[0];
const wait = () => window.flowcert ? window.flowcert.ready.then(() => done(true)) : setTimeout(wait, 20);
wait();
"""


class Browser:
    def __init__(self, width=1400, height=1000, flags=()):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for flag in [*FLAGS, f"--window-size={width},{height}", *flags]:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(DRIVER))
        self.driver.set_script_timeout(90)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def go(self, path, fragment=""):
        """Opens a page, always anew: an address that differs in its fragment alone would not be loaded."""
        self.driver.get("about:blank")
        self.driver.get(pathlib.Path(path).resolve().as_uri() + fragment)

    def open(self, path, fragment=""):
        self.go(path, fragment)
        self.driver.execute_async_script(WAIT)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def ask(self, call, *arguments):
        """flowcert.CALL(arguments…), a promise or not."""
        script = "const done = arguments[arguments.length - 1]; const given = [...arguments].slice(0, -1);" \
                 f"Promise.resolve(window.flowcert.{call}(...given)).then(done);"
        return self.driver.execute_async_script(script, *arguments)

    def rest(self, most=30.0):
        """Waits until the scene has drawn what it should, and nothing moves."""
        end = time.monotonic() + most
        while not self.run("return flowcert.at_rest()"):
            assert time.monotonic() < end, "the scene does not come to rest"
            time.sleep(0.05)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def click_at(self, x, y, button=MouseButton.LEFT):
        actions = ActionBuilder(self.driver)
        actions.pointer_action.move_to_location(round(x), round(y))
        actions.pointer_action.click(button=button)
        actions.perform()

    def drag(self, start, end):
        actions = ActionBuilder(self.driver)
        actions.pointer_action.move_to_location(round(start[0]), round(start[1]))
        actions.pointer_action.pointer_down()
        actions.pointer_action.move_to_location(round((start[0] + end[0]) / 2), round((start[1] + end[1]) / 2))
        actions.pointer_action.move_to_location(round(end[0]), round(end[1]))
        actions.pointer_action.pointer_up()
        actions.perform()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def forget(self):
        self.driver.get_log("browser")
        self.driver.get_log("performance")

    def messages(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        asked = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] in ("Network.requestWillBeSent", "Network.webSocketCreated"):
                parameters = message["params"]
                address = parameters.get("url") or parameters["request"]["url"]
                is_page = address.startswith("file:") and parameters.get("type") == "Document"
                if not is_page and not address.startswith(("data:", "blob:", "about:")):
                    asked.append(address)
        return asked
