"""A headless Chromium that stays open: real pointers, fingers and keys go to a page, and it draws by
its own clock. It is spoken to by Chromium's DevTools protocol over two pipes."""

import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

from browser import FLAGS

TIME_LIMIT = 120


class LiveBrowser:
    """with LiveBrowser() as browser: browser.open(path, fragment)"""

    def __init__(self, width=800, height=600):
        self.size = (width, height)
        self.number = 0
        self.session = None
        self.rest = b""
        self.events = []  # that came while something was asked

    def __enter__(self):
        chromium = shutil.which("chromium")
        if chromium is None:
            raise AssertionError("chromium is not installed: scripts/setup installs it")
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read, self.out = os.pipe()
        self.back, write = os.pipe()
        # Chromium reads file descriptor 3 and writes to 4.
        script = f'exec "$0" "$@" 3<&{read} 4>&{write}'
        self.process = subprocess.Popen(
            ["bash", "-c", script, chromium, *FLAGS, "--remote-debugging-pipe",
             f"--user-data-dir={self.profile.name}",
             f"--window-size={self.size[0]},{self.size[1]}", "about:blank"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            pass_fds=(read, write), start_new_session=True)
        os.close(read)
        os.close(write)
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target,
                                 flatten=True)["sessionId"]
        return self

    def __exit__(self, *_):
        os.close(self.out)
        os.close(self.back)
        try:  # Chromium is many processes, all of one group of their own
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        self.profile.cleanup()

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + TIME_LIMIT
        while True:
            while b"\0" not in self.rest:
                if not select.select([self.back], [], [], max(0, end - time.monotonic()))[0]:
                    raise AssertionError(f"chromium does not answer {method}")
                more = os.read(self.back, 65536)
                if not more:
                    raise AssertionError(f"chromium ended at {method}")
                self.rest += more
            text, self.rest = self.rest.split(b"\0", 1)
            answer = json.loads(text)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise AssertionError(f"{method}: {answer['error']}")
                return answer["result"]
            if "method" in answer:
                self.events.append(answer)

    def open(self, path, fragment=""):
        """Loads a page, and waits until it has drawn."""
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=f"file://{path}#{fragment}")
        end = time.monotonic() + TIME_LIMIT
        # The panel shows what is drawn after the first frame.
        while not self.value("document.getElementById('cells-shown')?.dataset.drawn ?? ''"):
            if time.monotonic() > end:
                raise AssertionError("the page does not draw: " + self.value(
                    "document.getElementById('notice')?.textContent ?? 'no page'"))
            time.sleep(0.05)

    def value(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        return answer["result"].get("value")

    def status(self):
        return self.value("document.getElementById('status').textContent")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, seconds, x=300, y=200):
        """Turns by the left button, to and fro, for so long."""
        self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        end, step = time.monotonic() + seconds, 0
        while time.monotonic() < end:
            step += 1
            self.mouse("mouseMoved", x + 3 * (step % 40), y, button="left", buttons=1)
            time.sleep(0.004)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)

    def hold(self, key, seconds):
        """Holds a key; returns what the page says before it is released."""
        self.call("Input.dispatchKeyEvent", type="rawKeyDown", key=key)
        time.sleep(seconds)
        status = self.status()
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)
        return status

    def fingers(self, kind, *places):
        self.call("Input.dispatchTouchEvent", type=kind,
                  touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)])

    def key(self, text):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=text,
                      text=text if kind == "keyDown" else "")

    def view(self):
        """What the address says of the view after the key L."""
        self.key("l")
        pairs = self.value("location.hash.slice(1)").split("&")
        return dict(pair.split("=", 1) for pair in pairs if "=" in pair)
