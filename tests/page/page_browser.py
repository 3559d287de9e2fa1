"""The page for browsers in a headless Chromium: what it says, what it asks of the network, what it
complains of."""

import base64
import json
import os
import time
from pathlib import Path

from live_browser import LiveBrowser

TIME_LIMIT = 90


def page_path():
    """The built page: of TRIPUS_PAGE, or of scripts/page."""
    named = os.environ.get("TRIPUS_PAGE")
    return Path(named) if named else Path(__file__).resolve().parents[2] / "build/page/tripus.html"


class PageBrowser(LiveBrowser):
    def __enter__(self):
        super().__enter__()
        self.watch()
        # Workers speak through sessions of their own.
        self.call("Target.setAutoAttach", autoAttach=True, waitForDebuggerOnStart=False, flatten=True)
        return self

    def watch(self):
        for domain in ("Runtime", "Log", "Network", "Page"):
            self.call(f"{domain}.enable")

    def attend(self):
        """Listens to workers that have begun."""
        for event in self.events:
            if event["method"] != "Target.attachedToTarget" or event.get("heard"):
                continue
            event["heard"] = True
            own, self.session = self.session, event["params"]["sessionId"]
            try:
                for domain in ("Runtime", "Network"):
                    self.call(f"{domain}.enable")
            except AssertionError:
                pass  # it has ended already
            finally:
                self.session = own

    def resize(self, width, height, phone=False, dark=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=phone)
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def go(self, fragment="", path=None):
        """Opens the page anew, and waits until it is ready."""
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=f"file://{path or page_path()}" + (f"#{fragment}" if fragment else ""))
        self.wait("document.documentElement?.dataset.ready !== undefined")

    def wait(self, expression, what=""):
        end = time.monotonic() + TIME_LIMIT
        while not self.value(f"Boolean({expression})"):
            if time.monotonic() > end:
                raise AssertionError(f"{what or expression} does not come: "
                                     + str(self.value("document.body.innerText"))[:1500])
            self.attend()
            time.sleep(0.05)

    def text(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)})?.innerText ?? ''")

    def click(self, selector):
        """A real click in the middle of an element, once that has come to rest."""
        end = time.monotonic() + TIME_LIMIT
        before = None
        while True:
            # The place, and whether the element is what lies there.
            found = self.value(
                f"(() => {{ const e = document.querySelector({json.dumps(selector)}); if (!e) return null;"
                "e.scrollIntoView({block: 'center', behavior: 'instant'}); const b = e.getBoundingClientRect();"
                "const at = [b.x + b.width / 2, b.y + b.height / 2], there = document.elementFromPoint(...at);"
                "return [at, there === null || e.contains(there) || there.contains(e)]; })()")
            if found is None:
                raise AssertionError(f"the page has no {selector}")
            if found == before and found[1]:
                break
            if time.monotonic() > end:
                raise AssertionError(f"{selector} does not come to rest, or something lies over it")
            before = found
            self.attend()
            time.sleep(0.05)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, *found[0], button="left", clickCount=1)

    def paste(self, text):
        """Into the field, in place of what was there, and Enter."""
        self.value("(() => { const q = document.getElementById('question'); q.focus(); q.select(); })()")
        self.call("Input.insertText", text=text)
        self.press("Enter")

    def press(self, key, shift=False):
        codes = {"Enter": 13, "Tab": 9, "Escape": 27, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39}
        more = {"windowsVirtualKeyCode": codes[key], "code": key} if key in codes else {"text": key}
        if key == "Enter":
            more["text"] = "\r"
        modifiers = 8 if shift else 0
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, modifiers=modifiers, **more)
        more.pop("text", None)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, modifiers=modifiers, **more)

    def solved(self, outcome="geometric"):
        self.wait(f"document.querySelector('#subject-badge .badge')?.textContent === '{outcome}'")

    def drawn(self):
        """Waits until the picture is there."""
        self.wait("document.getElementById('cells-shown')?.dataset.drawn === '1'", "the picture")

    def copied(self, selector):
        """What a button copies."""
        self.value("navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); };"
                   "window.copied = null;")
        self.click(selector)
        self.wait("window.copied !== null")
        return self.value("window.copied")

    def drop(self, path):
        """A file is dropped on the page, as by a hand."""
        # A browser drops what comes before it has shown anything.
        self.wait("performance.getEntriesByName('first-contentful-paint').length > 0", "the first frame")
        data = {"items": [], "files": [str(path)], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=300, y=300, data=data)

    def problem(self):
        return self.value("(() => { const p = document.getElementById('input-problem');"
                          "return p.hidden ? '' : p.textContent; })()")

    def screenshot(self, clip=None):
        more = {"clip": dict(zip(("x", "y", "width", "height"), clip), scale=1)} if clip else {}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **more)["data"])

    def complaints(self):
        """Errors and warnings of scripts and of the browser, so far."""
        self.value("1")  # what is on its way comes before this answer
        said = []
        for event in self.events:
            told = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                said.append(json.dumps(told["exceptionDetails"])[:600])
            if event["method"] == "Runtime.consoleAPICalled" and told["type"] in ("error", "warning", "assert"):
                said.append(json.dumps(told["args"])[:600])
            if event["method"] == "Log.entryAdded" and told["entry"]["level"] in ("error", "warning"):
                said.append(told["entry"]["text"])
        return said

    def requests(self):
        """Addresses that were asked for, but for the page itself and what it holds."""
        self.value("1")
        return [event["params"]["request"]["url"] for event in self.events
                if event["method"] == "Network.requestWillBeSent"
                and not event["params"]["request"]["url"].startswith(("file:", "data:", "blob:", "about:"))]
