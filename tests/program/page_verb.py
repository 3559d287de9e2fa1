"""tripus page: the page for browsers as a file, and what is said where it is missing."""

import os
import shutil
import subprocess
from unittest import mock

from support import ProgramTest, read_json

MARK = b'<meta name="generator" content="tripus 0.1.0">'
PAGE = b"<!doctype html>\n" + MARK + bytes(range(256)) * 40


class PageVerb(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("made.html", PAGE)
        patch = mock.patch.dict(os.environ, TRIPUS_PAGE=str(self.folder / "made.html"))
        patch.start()
        self.addCleanup(patch.stop)

    def test_is_a_copy(self):
        result = self.run_program("page", "-o", "out.html")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertIn("out.html", result.text)
        self.assertEqual((self.folder / "out.html").read_bytes(), PAGE)
        answer = self.json_answer("page", "-o", "again.html")
        self.assertEqual((answer["file"], answer["bytes"]), ("again.html", len(PAGE)))
        self.assertEqual((self.folder / "again.html").read_bytes(), PAGE)

    def test_says_what_is_wrong(self):
        self.assert_refused("page", says="--output is required")
        self.assert_refused("page", "-o", "no/such/folder/out.html", says="no/such/folder")
        os.environ["TRIPUS_PAGE"] = "no-such-page.html"
        self.assert_refused("page", "-o", "out.html", says="no-such-page.html")
        for other in (b"", b"<!doctype html>\n<title>Another page</title>\n"):
            self.write("other.html", other)
            os.environ["TRIPUS_PAGE"] = str(self.folder / "other.html")
            self.assert_refused("page", "-o", "out.html", says="other.html\" is not the page that scripts/page makes")
        self.assert_refused("page", "-o", "out.txt", says=".html")
        self.assertFalse((self.folder / "out.html").exists())

    def run_copy(self, place):
        """The program at another place, which has no build around it."""
        place.mkdir(parents=True)
        shutil.copy(os.environ["TRIPUS_PROGRAM"], place / "tripus")
        environment = {key: value for key, value in os.environ.items() if key != "TRIPUS_PAGE"}
        return subprocess.run([place / "tripus", "page", "-o", "out.html", "--json"], cwd=self.folder,
                              env=environment, capture_output=True, timeout=60, check=False)

    def test_names_the_remedy_where_it_is_missing(self):
        result = self.run_copy(self.folder / "alone" / "bin")
        self.assertEqual(result.returncode, 2)
        error = read_json(result.stdout.decode())["error"]
        self.assertEqual(error["kind"], "unsupported")
        for words in ("scripts/page", "TRIPUS_PAGE"):
            self.assertIn(words, error["message"])
        self.assertFalse((self.folder / "out.html").exists())

    def test_finds_what_was_installed(self):
        installed = self.folder / "usr" / "share" / "tripus"
        installed.mkdir(parents=True)
        (installed / "tripus.html").write_bytes(PAGE)
        self.assertEqual(self.run_copy(self.folder / "usr" / "bin").returncode, 0)
        self.assertEqual((self.folder / "out.html").read_bytes(), PAGE)
