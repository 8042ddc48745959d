"""The page that computes, as a person uses it, and a static server for it.

Guarantees: files are dropped by the browser's own events, and downloads are files on disk. The server notes all that it
is asked for.
"""
import contextlib
import http.server
import threading
import time

class Server:
    """Answers with a file, whatever the path, and notes what it is asked for."""

    def __init__(self, content):
        self.asked = asked = []

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                asked.append(self.path)
                self.send_response(200)
                self.send_header("Content-Type", "text/html")
                self.send_header("Content-Length", str(len(content)))
                self.end_headers()
                self.wfile.write(content)

            do_POST = do_GET

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.address = f"http://127.0.0.1:{self.server.server_port}/"

    def __enter__(self):
        threading.Thread(target=self.server.serve_forever, args=(0.05,), daemon=True).start()
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


class ComputingPage:
    def __init__(self, browser, folder):
        self.browser, self.folder = browser, folder

    def open(self, address):
        self.browser.driver.get("about:blank")
        self.browser.driver.get(address)
        self.browser.run("""
          window.parts = [];
          const note = () => { window.dropped = performance.timeOrigin + performance.now(); };
          addEventListener('drop', note, true);
          view.addEventListener('load', () => view.contentWindow.addEventListener('drop', note, true));
          new MutationObserver(() => parts.push([part.textContent, progress.value, seconds.textContent])).observe(
            work, {subtree: true, childList: true, attributes: true});""")

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def drop(self, *paths, at=(300, 200)):
        """As a person does, by the browser's own events."""
        data = {"items": [], "files": [str(path) for path in paths], "dragOperationsMask": 1}
        self.browser.run("window.dropped = 0")
        for kind in ("dragEnter", "dragOver", "drop"):
            self.browser.driver.execute_cdp_cmd("Input.dispatchDragEvent",
                                                {"type": kind, "x": at[0], "y": at[1], "data": data})
        end = time.monotonic() + 20
        while not self.browser.run("return window.dropped"):
            assert time.monotonic() < end, "the page sees no drop"
            time.sleep(0.01)

    def state(self):
        return self.browser.run("return document.body.dataset.state")

    def rest(self, most=60.0):
        """Waits until nothing is computed."""
        end = time.monotonic() + most
        while self.state() == "busy":
            assert time.monotonic() < end, "the page does not come to an end"
            time.sleep(0.02)

    def compute(self, path):
        self.drop(path)
        self.rest()
        assert self.said("error") == ""

    def said(self, kind=""):
        strip = self.browser.find("#strip")
        return self.browser.find("#said").text if strip.is_displayed() and kind in strip.get_attribute("class") else ""

    def told(self):
        return self.browser.find("#told").text

    @contextlib.contextmanager
    def frame(self):
        """Within the picture, once it is drawn."""
        self.browser.driver.switch_to.frame("view")
        try:
            self.browser.driver.execute_async_script(
                "const done = arguments[0]; const wait = () => window.flowcert ?"
                "flowcert.ready.then(() => done()) : setTimeout(wait, 10); wait();")
            yield
        finally:
            self.browser.driver.switch_to.default_content()

    def download(self, kind):
        """The name and the content of the file that a button saves."""
        before = set(self.folder.iterdir())
        self.browser.find(f"[data-file={kind}]").click()
        end = time.monotonic() + 30
        while True:
            new = set(self.folder.iterdir()) - before
            if new and not any(path.name.startswith(".") or path.suffix == ".crdownload" for path in new):
                path, = new
                return path.name, path.read_bytes()
            assert time.monotonic() < end, "nothing is saved"
            time.sleep(0.02)
