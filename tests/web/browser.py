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

# The scene as `data`, four numbers a pixel, and where it is.
PIXELS = """
const canvas = document.getElementById('scene'), copy = document.createElement('canvas');
const box = canvas.getBoundingClientRect();
flowcert.redraw_now();
Object.assign(copy, {width: canvas.width, height: canvas.height});
const context = copy.getContext('2d', {willReadFrequently: true});
context.drawImage(canvas, 0, 0);
const data = context.getImageData(0, 0, copy.width, copy.height).data;
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

    def color_at(self, x, y):
        """Red, green, blue and opacity of the scene at a pixel of the page."""
        return self.run(f"{PIXELS} const at = 4 * (Math.round(arguments[1] - box.top) * copy.width +"
                        "Math.round(arguments[0] - box.left)); return [...data.slice(at, at + 4)]", x, y)

    def count_of_color(self, name, most=40):
        """How many pixels of the scene are near a colour of the page, which has it as --NAME."""
        return self.run(PIXELS + """
          const hex = getComputedStyle(document.documentElement).getPropertyValue('--' + arguments[0]).trim();
          const wanted = [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16));
          let count = 0;
          for (let i = 0; i < data.length; i += 4)
            count += data[i + 3] > 200 && wanted.every((part, k) => Math.abs(data[i + k] - part) <= arguments[1]);
          return count;""", name, most)

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
