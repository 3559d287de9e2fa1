"""Opens a page in a headless Chromium, which draws WebGL2 in software, and reads what it shows."""

import html
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile

FLAGS = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--hide-scrollbars",
         "--disable-dev-shm-usage"]
# A picture of 200x150 takes seconds; a browser that hangs must not hang the tests.
TIME_LIMIT = 240


def page_text(path, fragment="", flags=(), window=(500, 400)):
    """The HTML of a page after its scripts have run."""
    chromium = shutil.which("chromium")
    if chromium is None:
        raise AssertionError("chromium is not installed: scripts/setup installs it")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [chromium, *FLAGS, *flags, f"--user-data-dir={profile}",
                   f"--window-size={window[0]},{window[1]}", "--virtual-time-budget=2000",
                   "--dump-dom", f"file://{path}" + (f"#{fragment}" if fragment else "")]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   stdin=subprocess.DEVNULL, start_new_session=True)
        try:
            out, err = process.communicate(timeout=TIME_LIMIT)
        finally:
            # Chromium is many processes, all of one group of their own.
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()
    text = out.decode("utf-8", "replace")
    if "</html>" not in text:
        raise AssertionError(f"chromium wrote no page: {err.decode('utf-8', 'replace')[-2000:]}")
    return text


class Picture:
    """What the page wrote about one picture of itself (viewer/web/dump.js)."""

    def __init__(self, facts):
        self.facts = facts
        self.problem = self.facts["problem"]
        if not self.problem:
            self.width, self.height = self.facts["width"], self.facts["height"]
            self.identities = bytes.fromhex(self.facts["identities"])
            self.colours = bytes.fromhex(self.facts["colours"])

    def at(self, pixels, x, y):
        """Four bytes of a pixel, y from the bottom."""
        start = 4 * (y * self.width + x)
        return tuple(pixels[start:start + 4])


def notice(text):
    """What the page says in place of a picture."""
    found = re.search(r'<p id="notice"([^>]*)>(.*?)</p>', text, re.DOTALL)
    return html.unescape(found.group(2)) if found and "hidden" not in found.group(1) else ""


def draw(path, *fragments):
    """A picture for each fragment, all by one browser."""
    text = page_text(path, "|".join(f"dump=1&{fragment}" for fragment in fragments))
    found = re.search(r'<pre id="dump"[^>]*>(.*?)</pre>', text, re.DOTALL)
    if found is None:
        raise AssertionError(f"the page drew nothing: {notice(text)}")
    return [Picture(facts) for facts in json.loads(html.unescape(found.group(1)))]


def page_data(text):
    """The manifold of a page, from its source."""
    found = re.search(r'<script type="application/json" id="manifold-data">(.*?)</script>', text,
                      re.DOTALL)
    return json.loads(found.group(1))
