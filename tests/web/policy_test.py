"""The policy of the page that computes: whatever asks a host is blocked, in the page, in its workers, in its frame.

Guarantees: each way of asking is seen to be blocked, and none arrives. All of them arrive where the policy is taken out
of the page, so that the ways are right.
"""
import re
import time

import pytest

import inputs
from computing_page import ComputingPage, Server

COMMON = """
const ways = {
  fetch: (to) => fetch(to, {mode: 'no-cors'}),
  request: (to) => { const request = new XMLHttpRequest(); request.open('GET', to); request.send(); },
  socket: (to) => new WebSocket(to.replace('http', 'ws')),
};
const seen = {};
addEventListener('securitypolicyviolation', (event) => {
  const path = new URL(event.blockedURI).pathname;  // of a frame the host alone is told
  seen[path === '/' ? path + event.effectiveDirective.replace('-src', '') : path] = event.type;
});
const go = (host, then) => {
  for (const [name, way] of Object.entries(ways))
    try { Promise.resolve(way(host + name)).catch(() => {}); } catch {}
  setTimeout(() => then(seen), 300);
};
"""
DOCUMENT = COMMON + """
const add = (tag, attributes) => document.body.append(Object.assign(document.createElement(tag), attributes));
Object.assign(ways, {
  beacon: (to) => navigator.sendBeacon(to),
  image: (to) => add('img', {src: to}),
  script: (to) => add('script', {src: to}),
  module: (to) => import(to),
  style: (to) => add('link', {rel: 'stylesheet', href: to}),
  frame: (to) => add('iframe', {src: to}),
  object: (to) => add('object', {data: to}),
  video: (to) => add('video', {src: to}),
});
go(...arguments);
"""
WORKER = "const [host, done] = arguments;" + """
const code = `COMMON
ways.script = (to) => importScripts(to);
onmessage = ({data}) => go(data, (seen) => postMessage(seen));`;
const worker = new Worker(URL.createObjectURL(new Blob([code], {type: 'text/javascript'})));
worker.onmessage = ({data}) => done(data);
worker.postMessage(host);
""".replace("COMMON", COMMON)
IN_DOCUMENT = {"fetch", "request", "socket", "beacon", "image", "script", "module", "style", "frame", "object", "video"}
IN_WORKER = {"fetch", "request", "socket", "script"}


def asked(page, host, place):
    """What was seen to be blocked; and what has arrived, which is waited for where nothing is blocked."""
    host.asked.clear()
    script = WORKER if place == "worker" else DOCUMENT
    if place == "frame":
        page.compute(page.file("square.xyz", inputs.TEXTS["square"]))
        with page.frame():
            seen = page.browser.driver.execute_async_script(script, host.address)
    else:
        seen = page.browser.driver.execute_async_script(script, host.address)
    expected = {f"/{way}" for way in (IN_WORKER if place == "worker" else IN_DOCUMENT)}
    end = time.monotonic() + 10
    while not seen and not expected <= set(host.asked) and time.monotonic() < end:
        time.sleep(0.02)
    return expected, set(seen), set(host.asked)


@pytest.mark.parametrize("place", ["page", "worker", "frame"])
def test_requests_are_blocked(unread_page, place):
    with Server(b"") as host:
        expected, seen, arrived = asked(unread_page, host, place)
    assert seen == expected and arrived == set()


@pytest.mark.parametrize("place", ["page", "worker"])
def test_they_arrive_without_the_policy(unread_page, computing, place):
    open_page, count = re.subn(rb'<meta http-equiv="Content-Security-Policy"[^>]*>', b"", computing)
    assert count == 1
    with Server(open_page) as server, Server(b"") as host:
        unread_page.open(server.address)
        expected, seen, arrived = asked(unread_page, host, place)
    assert seen == set() and arrived == expected
