"""The page for browsers: what a user does with it, by a real mouse, keyboard and file."""

import shutil
import time
from pathlib import Path

import samples
from page_browser import PageBrowser, page_path
from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json
from view import read_png

WITHOUT_METRIC = "eLAkbccdddprdk"
#: t3g3.13 of the census has no isometry but the identity.
ASYMMETRIC = "eLAkaccddjcwdr"
DIALECTS = Path(__file__).resolve().parents[1] / "dialects"
#: The picture alone, in a corner of the window, in this page and in that of `tripus view`.
ALONE = ("document.head.append(Object.assign(document.createElement('style'), {textContent:"
         "'#stage{position:fixed!important;inset:0 auto auto 0!important;width:320px!important;"
         "height:240px!important;z-index:99}#stage>:not(canvas){display:none!important}"
         "#picture{outline:none!important}'}))")
#: Seconds are never the same twice.
CHANGES = ("seconds",)


def without_times(answer):
    return {key: value for key, value in answer.items() if key not in CHANGES}


class PageTest(ProgramTest):
    """One browser for all tests of a class. After every test nothing was complained of, and nothing
    was asked of any network."""

    FLAGS = ()

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = PageBrowser(1200, 800)
        cls.browser.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        super().tearDownClass()

    def setUp(self):
        super().setUp()
        self.browser.events.clear()
        self.browser.resize(1200, 800)

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.requests(), [])
        super().tearDown()

    def solve(self, text, outcome="geometric"):
        self.browser.go()
        self.browser.paste(text)
        self.browser.solved(outcome)

    def program_says(self, *arguments):
        """The JSON objects of a run, one a line."""
        result = self.run_program(*arguments, "--json")
        return [read_json(line) for line in result.lines]


class Answers(PageTest):
    def test_solves_what_is_pasted(self):
        self.solve(TRIPUS)
        self.browser.drawn()
        facts = self.browser.text("#subject-facts")
        for words in (f"{TRIPUS_VOLUME:.11f}"[:12], "genus 2", "2 Z", "2, orientable", TRIPUS):
            self.assertIn(words, facts)
        answer = read_json(self.browser.copied("#copy-json"))
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)
        program, = self.program_says("solve", TRIPUS)
        self.assert_same(answer, program)

    def assert_same(self, page, program):
        """The same keys in the same order, the same words and integers, and numbers to 1e-12."""
        self.assertEqual(type(page), type(program))
        if isinstance(page, dict):
            self.assertEqual(list(page), list(program))
            for key in page:
                if key not in CHANGES:
                    with self.subTest(key):
                        self.assert_same(page[key], program[key])
        elif isinstance(page, list):
            self.assertEqual(len(page), len(program))
            for one, other in zip(page, program):
                self.assert_same(one, other)
        elif isinstance(page, float):
            self.assertAlmostEqual(page, program, delta=1e-12 * max(1, abs(program)))
        else:
            self.assertEqual(page, program)

    def ask(self, name):
        before = self.browser.value("document.querySelectorAll('.card').length")
        self.browser.click(f"[data-ask={name}]")
        self.browser.wait(f"document.querySelectorAll('.card').length === {before + 1} &&"
                          "!document.querySelector('.card').hasAttribute('aria-busy')")
        self.assertEqual(self.browser.text(".card .problem"), "")
        return [read_json(line) for line in self.browser.copied(".card header button").splitlines() if line]

    def test_whatever_is_asked_is_what_the_program_says(self):
        self.solve(TRIPUS)
        self.browser.drawn()
        self.browser.value("document.getElementById('other').value = 'cPcbbbdhq'")
        for name, arguments in {
                "identify": ("identify", TRIPUS), "canonize": ("canonize", TRIPUS),
                "simplify": ("simplify", TRIPUS), "cover": ("cover", TRIPUS, "--degree", "2"),
                "orthospectrum": ("orthospectrum", TRIPUS, "--count", "20"),
                "compare": ("compare", TRIPUS, "cPcbbbdhq")}.items():
            with self.subTest(name):
                page, program = self.ask(name), self.program_says(*arguments)
                self.assertEqual(len(page), len(program))
                for one, other in zip(page, program):
                    self.assert_same(one, other)
        for words in ("t2g2.8", "dihedral of order 6", "Not homeomorphic", "connected covers"):
            self.assertIn(words, self.browser.text("#cards-of-answers"))

    def test_finds_another_triangulation(self):
        self.solve(WITHOUT_METRIC, "degenerate")
        self.assertIn("no picture", self.browser.text("#no-picture"))
        self.browser.click(".hint button")
        self.browser.wait("document.querySelector('.card .open')")
        self.browser.click(".card .open")
        self.browser.wait("document.getElementById('subject-name').textContent !== '" + WITHOUT_METRIC + "'")
        self.browser.solved()
        self.browser.drawn()
        self.assertIn("7.63651962", self.browser.text("#subject-facts"))
        self.browser.value("history.back()")
        self.browser.solved("degenerate")

    def test_reads_diagrams_and_gluings(self):
        for text, words in {
                "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]": "2.02988321",
                "5_1 theta": "6.4519902", "t3g2.13": "7.63651962",
                (DATA / "knotted-y-gluings.json").read_text(): "6.4519902"}.items():
            with self.subTest(text):
                self.solve(text)
                self.assertIn(words, self.browser.text("#subject-facts"))

    def test_draws_diagrams(self):
        for text in ("hk5_3", "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]"):
            with self.subTest(text):
                program, = self.program_says("solve", text)
                self.solve(text, program["outcome"])
                self.browser.wait("document.querySelector('#subject-diagram svg')")
                drawn = self.run_program("draw", text, "--size", "220").text
                strands = self.browser.value("document.querySelectorAll('#subject-diagram path').length")
                self.assertEqual(strands, drawn.count("<path"))


class BadInput(PageTest):
    TEXTS = ("xyz", "--help", "cPcbbbihz", "PD: V[1,2", "PD: X[1,2,3,4]", '{"gluings": [[1]]}', "no such knot",
             "t9g9.1", "cPcbbbihq<b>&amp;", "#")

    def message(self, text):
        """What the program says of a text: of a file's content if it is JSON, or if it would be an option."""
        name = self.write("input", text) if text.startswith(("{", "-")) else text
        result = self.run_program("info", name)
        self.assertEqual(result.status, 2)
        return result.err.removeprefix("tripus: ").rstrip("\n")

    def test_is_refused_in_the_words_of_the_program(self):
        self.browser.go()
        for text in self.TEXTS:
            with self.subTest(text):
                self.browser.paste(text)
                self.browser.wait("!document.getElementById('input-problem').hidden", text)
                self.assertEqual(self.browser.problem(), self.message(text))
                self.assertEqual(self.browser.value("document.activeElement.id"), "question")

    def test_leaves_what_was_there(self):
        self.solve(TRIPUS)
        self.browser.drawn()
        address = self.browser.value("location.hash")
        self.browser.paste("xyz")
        self.browser.wait("!document.getElementById('input-problem').hidden")
        self.assertEqual(self.browser.text("#subject-name"), TRIPUS)
        self.assertEqual(self.browser.value("location.hash"), address)
        self.browser.paste("cPcbbbdhq")
        self.browser.wait("document.getElementById('subject-name').textContent === 'cPcbbbdhq'")
        self.assertEqual(self.browser.problem(), "")

    def test_in_a_link_is_said(self):
        self.browser.go("input=xyz")
        self.browser.wait("!document.getElementById('input-problem').hidden")
        self.assertEqual(self.browser.problem(), self.message("xyz"))
        self.browser.go("packed=@@@")
        self.browser.wait("!document.getElementById('input-problem').hidden")
        self.assertIn("damaged", self.browser.problem())


class Files(PageTest):
    def drop(self, name, content):
        self.write(name, content)
        self.browser.go()
        self.browser.drop(self.folder / name)

    def test_are_read_when_they_are_dropped(self):
        gluings = samples.tripus_cover(3)
        for name, content in {
                "gluings.json": samples.as_json(gluings), "snappea.tri": samples.as_snappea(gluings),
                "regina.txt": samples.as_regina_table(gluings)}.items():
            with self.subTest(name):
                self.drop(name, content)
                self.browser.solved()
                self.browser.drawn()
                self.assertIn(f"{3 * TRIPUS_VOLUME:.11f}"[:10], self.browser.text("#subject-facts"))
                link = self.browser.copied("#copy-link")
                self.assertIn("packed=", link)
                self.browser.go(link.split("#", 1)[1])
                self.browser.solved()
                self.assertIn(f"{3 * TRIPUS_VOLUME:.11f}"[:10], self.browser.text("#subject-facts"))

    def test_of_others_are_read(self):
        path = DIALECTS / "snappea-free-form.tri"
        program, = self.program_says("solve", str(path))
        self.browser.go()
        self.browser.drop(path)
        self.browser.solved(program["outcome"])

    def test_with_several_ask_for_one(self):
        for name in ("regina-4.5.rga", "regina-two-compressed.rga"):
            with self.subTest(name):
                shutil.copy(DIALECTS / name, self.folder)
                self.browser.go()
                self.browser.drop(self.folder / name)
                self.browser.wait("!document.getElementById('input-problem').hidden")
                self.assertEqual("tripus: " + self.browser.problem() + "\n", self.run_program("info", name).err)
                program, = self.program_says("solve", f"{name}#second")
                self.browser.paste(f"{name}#second")
                self.browser.solved(program["outcome"])

    def test_that_are_damaged_are_refused(self):
        whole = (DIALECTS / "regina-two-compressed.rga").read_bytes()
        (self.folder / "cut.rga").write_bytes(whole[:100])
        self.browser.go()
        self.browser.drop(self.folder / "cut.rga")
        self.browser.wait("!document.getElementById('input-problem').hidden")
        self.assertIn("cut.rga: the content begins as what gzip compressed", self.browser.problem())

    def test_that_are_surfaces_are_told_what_needs_the_program(self):
        for path, form in {DATA.parent / "examples" / "surfaces" / "knotted-y.off": "OFF",
                           DIALECTS / "obj-split-points.obj": "OBJ", DIALECTS / "stl-upper-case.stl": "STL",
                           DIALECTS / "stl-trailing-bytes.stl": "STL",
                           DIALECTS / "pyvista-field.vtk": "VTK", DIALECTS / "meshio.vtu": "VTK XML"}.items():
            with self.subTest(path.name):
                self.browser.go()
                self.browser.drop(path)
                self.browser.wait("!document.getElementById('input-problem').hidden")
                for words in (path.name, f"({form})", "tripus mesh"):
                    self.assertIn(words, self.browser.problem())

    def test_that_are_nothing_are_refused_in_the_words_of_the_program(self):
        self.drop("nonsense.txt", "\x01nothing that\nanyone reads\n")
        self.browser.wait("!document.getElementById('input-problem').hidden")
        # The program's list of formats goes on with the surfaces and meshes that it reads.
        told, program = self.browser.problem(), self.run_program("info", "nonsense.txt").err
        self.assertIn("; surfaces and meshes (which need the program)", told)
        self.assertTrue(program.startswith("tripus: " + told.split("; surfaces and meshes")[0]), program)

    def test_are_chosen_too(self):
        self.write("gluings.json", samples.as_json(samples.tripus_cover(1)))
        self.browser.go()
        chooser = self.browser.call("Runtime.evaluate", expression="document.getElementById('file')")["result"]
        self.browser.call("DOM.setFileInputFiles", objectId=chooser["objectId"],
                          files=[str(self.folder / "gluings.json")])
        self.browser.solved()


class Pictures(PageTest):
    def picture(self):
        """The pixels of the picture at rest, rows from the top."""
        self.browser.value(ALONE)
        before = None
        for _ in range(60):
            now = self.browser.screenshot((0, 0, 320, 240))
            if now == before and self.browser.value("document.getElementById('picture').width === 320"):
                return read_png(now)[2]
            before = now
            time.sleep(0.7)
        raise AssertionError("the picture does not rest")

    def test_are_those_of_the_program_pixel_by_pixel(self):
        """Which are compared with traced rays: tests/program/web.py. Of a manifold without symmetries:
        the last bits of the metric choose among cells at one distance."""
        self.run_program("view", ASYMMETRIC, "-o", "page.html")
        pictures = {}
        for view in ("cells=50&yaw=1", "view=inside&place=wall&tube=0.05", "theme=dark&model=upper&colour=face"):
            with self.subTest(view):
                fragment = f"theme=light&{view}&fine=1" if "theme" not in view else f"{view}&fine=1"
                self.browser.go(f"input={ASYMMETRIC}&{fragment}")
                self.browser.solved()
                self.browser.drawn()
                page = self.picture()
                self.browser.call("Page.navigate", url="about:blank")
                self.browser.call("Page.navigate", url=f"file://{self.folder}/page.html#{fragment}")
                self.browser.drawn()
                program = self.picture()
                pixels = [one == other for a, b in zip(page, program) for one, other in zip(a, b)]
                self.assertEqual(len(pixels), 320 * 240)
                # The metric may differ in the last bit, and an edge by a pixel.
                self.assertGreaterEqual(sum(pixels), 0.999 * len(pixels))
                self.assertGreater(len({pixel for row in page for pixel in row}), 200)
                pictures[view] = page
        self.assertEqual(len({str(picture) for picture in pictures.values()}), 3)

    def test_move_under_the_mouse(self):
        self.browser.go(f"input={TRIPUS}")
        self.browser.drawn()
        first = self.view()
        self.browser.drag(0.3, 700, 400)
        turned = self.view()
        self.assertNotEqual(turned["yaw"], first["yaw"])

    def view(self):
        fragment = self.browser.copied("#copy-link").split("#", 1)[1]
        return dict(pair.split("=", 1) for pair in fragment.split("&"))

    def test_are_restored_from_a_link(self):
        self.browser.go(f"input={TRIPUS}&fine=1")  # as fine on a busy machine
        self.browser.drawn()
        self.browser.drag(0.3, 700, 400)
        self.browser.value("(() => { const c = document.getElementById('cells'); c.value = 6;"
                           "c.dispatchEvent(new Event('input')); })()")
        link = self.browser.copied("#copy-link").split("#", 1)[1]
        page = self.picture()
        self.assertIn(f"input={TRIPUS}", link)
        self.browser.go(f"{link}&fine=1")
        self.browser.drawn()
        self.assertEqual(self.browser.copied("#copy-link").split("#", 1)[1], link)
        again = self.picture()
        self.assertEqual(page, again)

    def test_of_cusps_are_drawn(self):
        self.browser.go("input=4_1")
        self.browser.solved()
        self.browser.drawn()
        self.assertGreater(len({pixel for row in self.picture() for pixel in row}), 200)


class Stops(PageTest):
    LONG = ("document.getElementById('cover-degree').add(new Option('9'));"
            "document.getElementById('cover-degree').value = '9'")

    def begin(self):
        self.solve(TRIPUS)
        self.browser.drawn()
        self.browser.value(self.LONG)
        self.browser.click("[data-ask=cover]")
        self.browser.wait("!document.getElementById('work').hidden")

    def test_end_a_long_run(self):
        for how in ("#stop", "Escape"):
            with self.subTest(how):
                self.begin()
                # The page answers while the worker works.
                self.browser.click("#day-night")
                self.browser.wait("document.documentElement.dataset.theme === 'dark'")
                self.assertFalse(self.browser.value("document.getElementById('work').hidden"))
                if how == "Escape":
                    self.browser.press("Escape")
                else:
                    self.browser.click("#stop")
                self.browser.wait("document.getElementById('work').hidden")
                self.browser.wait("document.querySelector('.card .problem')?.textContent === 'Stopped.'")
                self.browser.paste("cPcbbbdhq")
                self.browser.wait("document.getElementById('subject-name').textContent === 'cPcbbbdhq'")
                self.browser.solved()
                self.browser.drawn()


class Looks(PageTest):
    SIZES = {"phone": (390, 844, True), "tablet": (820, 1180, True), "desk": (1280, 800, False),
             "wall": (1920, 1080, False)}

    def check_fit(self):
        """Nothing is wider than the window, and what can be pressed lies in it and is large enough."""
        wide = self.browser.value("document.documentElement.scrollWidth - innerWidth")
        self.assertLessEqual(wide, 0)
        sideways = self.browser.value("(() => { const a = document.getElementById('answers');"
                                      "return a.scrollWidth - a.clientWidth; })()")
        self.assertLessEqual(sideways, 0)
        outside = self.browser.value("""[...document.querySelectorAll('button, input, select, textarea, summary')]
            .filter((e) => e.checkVisibility() && !e.closest('.scroll'))
            .map((e) => [e.id || e.textContent || e.className, e.getBoundingClientRect()])
            .filter(([, b]) => b.width > 0 && (b.left < -1 || b.right > innerWidth + 1))
            .map(([name]) => name)""")
        self.assertEqual(outside, [])
        unnamed = self.browser.value("""[...document.querySelectorAll('button, input, select, textarea, canvas, [role=region]')]
            .filter((e) => e.checkVisibility())
            .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.[0]?.textContent.trim()))
            .map((e) => e.outerHTML.slice(0, 100))""")
        self.assertEqual(unnamed, [])

    def check_contrast(self):
        """Words on their background differ by 4.5 at least, as WCAG AA asks."""
        faint = self.browser.value(r"""(() => {
          const canvas = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
          const rgba = (css) => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = css; canvas.fillRect(0, 0, 1, 1);
                                  return [...canvas.getImageData(0, 0, 1, 1).data]; };
          const light = ([r, g, b]) => [r, g, b].map((x) => x / 255)
              .map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4))
              .reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
          const behind = (e) => { for (; e; e = e.parentElement) {
              const colour = rgba(getComputedStyle(e).backgroundColor);
              if (colour[3] > 200) return colour; } return rgba('white'); };
          return [...document.querySelectorAll('h2, h3, p, dt, dd, button, label, summary, .note, .badge, td, th')]
              .filter((e) => e.checkVisibility() && e.textContent.trim() && !e.closest('#place-stage'))
              .map((e) => { const [a, b] = [rgba(getComputedStyle(e).color), behind(e)].map(light);
                            return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.outerHTML.slice(0, 90)]; })
              .filter(([ratio]) => ratio < 4.5).map(([ratio, what]) => `${ratio.toFixed(2)} ${what}`);
        })()""")
        self.assertEqual(faint, [])

    def test_fit_every_size_by_day_and_night(self):
        for name, (width, height, phone) in self.SIZES.items():
            for dark in (False, True):
                with self.subTest(name, dark=dark):
                    self.browser.resize(width, height, phone, dark)
                    self.browser.go()
                    self.browser.wait("document.querySelectorAll('#cards li').length > 1")
                    self.browser.value("document.getElementById('cards').scrollIntoView()")
                    self.browser.wait("document.querySelectorAll('#cards svg').length > 1")
                    theme = self.browser.value("document.documentElement.dataset.theme")
                    self.assertEqual(theme, "dark" if dark else "light")
                    self.check_fit()
                    self.check_contrast()
                    self.browser.go(f"input={TRIPUS}")
                    self.browser.drawn()
                    for count, ask in enumerate(("canonize", "cover", "orthospectrum"), 1):
                        self.browser.click(f"[data-ask={ask}]")
                        self.browser.wait(f"document.querySelectorAll('.card').length === {count} &&"
                                          "!document.querySelector('.card[aria-busy]')")
                    self.browser.value("for (const e of document.querySelectorAll('#answers details')) e.open = true")
                    self.check_fit()
                    if width > 900:  # the answers scroll beside the picture, and the page does not
                        long = self.browser.value("document.documentElement.scrollHeight - innerHeight")
                        self.assertLessEqual(long, 0)
                    self.check_contrast()
                    box = self.browser.value("(() => { const b = document.getElementById('picture')"
                                             ".getBoundingClientRect(); return [b.width, b.height]; })()")
                    self.assertGreater(min(box), 300)

    def test_a_finger_turns_the_picture(self):
        self.browser.resize(390, 844, True)
        self.browser.go(f"input={TRIPUS}")
        self.browser.drawn()
        before = self.browser.copied("#copy-link")
        self.browser.value("scrollTo(0, 0)")
        self.browser.fingers("touchStart", (150, 250))
        self.browser.fingers("touchMove", (210, 250))
        self.browser.fingers("touchEnd")
        self.assertNotEqual(self.browser.copied("#copy-link"), before)


class Keys(PageTest):
    def focused(self):
        return self.browser.value("document.activeElement.id || document.activeElement.textContent")

    def test_are_enough(self):
        self.browser.resize(1400, 900)
        self.browser.go()
        self.browser.press("Tab")
        self.assertEqual(self.focused(), "skip")
        self.browser.press("Enter")
        self.assertEqual(self.focused(), "question")
        self.browser.call("Input.insertText", text=TRIPUS)
        self.browser.press("Enter")
        self.browser.solved()
        self.browser.drawn()
        seen = []
        for _ in range(80):
            self.browser.press("Tab")
            if self.browser.value("document.activeElement === document.body"):
                break  # the browser's own buttons are next
            seen.append(self.focused())
            self.assertNotEqual(self.browser.value("getComputedStyle(document.activeElement).outlineStyle"),
                                "none", seen[-1])
        for name in ("solve", "choose-file", "show-history", "copy-json", "Identify", "cover-degree", "picture",
                     "Inside", "model"):
            self.assertIn(name, seen)

    def test_turn_the_picture(self):
        self.browser.go(f"input={TRIPUS}")
        self.browser.drawn()
        self.browser.value("document.getElementById('picture').focus()")
        before = self.browser.view()
        self.browser.call("Input.dispatchKeyEvent", type="rawKeyDown", key="ArrowLeft")
        after, end = before, time.monotonic() + 60
        while after["yaw"] == before["yaw"] and time.monotonic() < end:
            time.sleep(0.3)
            after = self.browser.view()
        self.browser.call("Input.dispatchKeyEvent", type="keyUp", key="ArrowLeft")
        self.assertNotEqual(after["yaw"], before["yaw"])
        self.assertEqual(after["input"], TRIPUS)
        self.browser.press("/")
        self.assertEqual(self.focused(), "question")

    def test_say_what_there_is(self):
        """Changes are told to those who do not see them."""
        self.browser.go()
        self.assertEqual(self.browser.value("document.getElementById('work-text').getAttribute('role')"), "status")
        self.assertEqual(self.browser.value("document.getElementById('input-problem').getAttribute('role')"), "alert")
        tree = self.browser.call("Accessibility.getFullAXTree")["nodes"]
        roles = {node["role"]["value"] for node in tree if not node.get("ignored")}
        self.assertLessEqual({"banner", "main", "heading", "search", "textbox", "button"}, roles)


class Tables(PageTest):
    def test_are_shown_with_their_diagrams(self):
        self.browser.go("gallery=handlebody-knots")
        program = read_json(self.run_program("table", "handlebody-knots", "--json").text)
        self.browser.wait(f"document.querySelectorAll('#cards li').length === {len(program['rows'])}")
        self.browser.wait("document.querySelector('#cards svg')")
        self.browser.value("(() => { const f = document.getElementById('find'); f.value = 'hk5_3';"
                           "f.dispatchEvent(new Event('input')); })()")
        shown = self.browser.value("[...document.querySelectorAll('#cards li')].filter((e) => !e.hidden).length")
        self.assertEqual(shown, 1)
        self.browser.click("#cards li:not([hidden]) button")
        self.browser.wait("document.getElementById('subject-name').textContent === 'hk5_3'")

    def cards(self):
        return self.browser.value("[...document.querySelectorAll('#cards li b')].map((b) => b.textContent)")

    def fill(self, name, text):
        self.browser.value(f"(() => {{ const f = document.getElementById('{name}'); f.value = '{text}';"
                           "f.dispatchEvent(new Event('input')); f.dispatchEvent(new Event('change')); })()")

    def test_the_census_is_shown_in_pages(self):
        program = self.program_says("census")
        names = [row["name"] for row in program]
        self.assertGreater(len(names), 5160)  # and those with cusps
        self.browser.go("gallery=census")
        self.browser.wait("document.querySelectorAll('#cards li').length > 100")
        self.assertEqual(self.browser.text("#card-count"), f"{len(names)} of {len(names)} manifolds")
        size = len(self.cards())
        self.assertEqual(self.cards(), names[:size])
        self.assertEqual(self.browser.text("#page-number"), f"1 to {size} of {len(names)}")
        self.browser.click("#page-after")
        self.assertEqual(self.cards(), names[size:2 * size])
        self.fill("find", "2 z + z_3")
        wanted = [row for row in program if "2 Z + Z_3" in row["H1"]]
        self.assertEqual(self.browser.text("#card-count"), f"{len(wanted)} of {len(names)} manifolds")
        self.assertEqual(self.cards(), [row["name"] for row in wanted][:size])
        self.fill("find", "t4g3.")
        self.fill("order", "volume")
        volumes = {row["name"]: row["volume"] for row in program}
        shown = [volumes[name] for name in self.cards()]
        self.assertGreater(len(shown), 50)
        self.assertEqual(shown, sorted(shown))
        first = self.cards()[0]
        self.assertIn(f"{volumes[first]:.8f}"[:9], self.browser.text("#cards li"))
        self.browser.click("#cards li button")
        self.browser.wait(f"document.getElementById('subject-name').textContent === '{first}'")
        self.browser.solved()

    def test_all_open(self):
        self.browser.go()
        self.browser.wait("document.querySelector('#cards svg')")  # nothing moves any more
        for name, title in (("theta-curves", "5_1 theta"), ("knots", "8_19"), ("links", "L5a1")):
            self.browser.click(f"[data-table={name}]")
            self.browser.wait(f"document.getElementById('cards').textContent.includes('{title}')")


class History(PageTest):
    def test_is_kept_and_forgotten(self):
        for text in (TRIPUS, "cPcbbbdhq"):
            self.solve(text)
            self.browser.drawn()
        self.browser.click("#show-history")
        self.assertEqual(self.browser.value(
            "[...document.querySelectorAll('#history-list a')].slice(0, 2).map((a) => a.textContent)"),
            ["cPcbbbdhq", TRIPUS])
        self.assertIn("volume 6.45199", self.browser.text("#history-list"))
        self.browser.click("#history-list li:nth-child(2) a")
        self.browser.wait(f"document.getElementById('subject-name').textContent === '{TRIPUS}'")
        self.browser.solved()
        self.browser.click("#show-history")
        self.browser.click("#clear-history")
        self.assertIn("Nothing yet", self.browser.text("#history-list"))


class Large(PageTest):
    def test_ten_thousand_tetrahedra_are_solved(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(5000)))
        self.browser.go()
        self.browser.drop(self.folder / "cover.json")
        self.browser.solved()
        self.assertIn("10000, orientable", self.browser.text("#subject-facts"))
        self.assertIn("Draw it", self.browser.text("#no-picture"))
        self.browser.paste(TRIPUS)
        self.browser.wait(f"document.getElementById('subject-name').textContent === '{TRIPUS}'")
        self.browser.solved()
        self.browser.drawn()


class Memory(PageTest):
    """A browser that gives the module no more than so many megabytes: growing fails, as it does at the end of
    real memory."""

    LIMIT = """(() => {
      const limit = %d << 20;
      const patch = `{
        const grow = WebAssembly.Memory.prototype.grow;
        WebAssembly.Memory.prototype.grow = function (pages) {
          if (this.buffer.byteLength + pages * 65536 > ${limit}) throw new RangeError('WebAssembly.Memory.grow(): Unable to grow instance memory');
          return grow.call(this, pages);
        };
      }`;
      window.Blob = class extends Blob {
        constructor(parts, options) { super(options?.type === 'text/javascript' ? [patch, ...parts] : parts, options); }
      };
    })()"""

    def limited(self, megabytes):
        added = self.browser.call("Page.addScriptToEvaluateOnNewDocument", source=self.LIMIT % megabytes)
        self.addCleanup(self.browser.call, "Page.removeScriptToEvaluateOnNewDocument", identifier=added["identifier"])

    def test_of_ten_thousand_tetrahedra_is_a_part_of_what_there_is(self):
        """The module may have 2048."""
        self.limited(64)
        self.write("cover.json", samples.as_json(samples.tripus_cover(5000)))
        self.browser.go()
        self.browser.drop(self.folder / "cover.json")
        self.browser.solved()
        self.assertIn("10000, orientable", self.browser.text("#subject-facts"))

    def test_that_is_too_small_is_said_and_the_page_goes_on(self):
        self.limited(32)
        self.write("cover.json", samples.as_json(samples.tripus_cover(30000)))
        self.browser.go()
        for _ in range(2):
            self.browser.drop(self.folder / "cover.json")
            self.browser.wait("document.body.innerText.includes('not enough memory')")
            said = self.browser.problem() or self.browser.text("#subject-message")
            self.assertRegex(said, r"not enough memory for 60000 tetrahedra \(needs about \d+ MB\)")
            self.browser.paste(TRIPUS)
            self.browser.wait(f"document.getElementById('subject-name').textContent === '{TRIPUS}'")
            self.browser.solved()
            self.browser.drawn()
            self.assertIn("6.45199027", self.browser.text("#subject-facts"))

    def test_that_ends_while_a_question_is_answered_is_said_in_its_place(self):
        self.limited(48)
        self.solve(TRIPUS)
        self.browser.drawn()
        self.browser.value("(() => { const count = document.getElementById('arc-count');"
                           "count.max = '1e9'; count.value = '3000000'; })()")
        self.browser.click("[data-ask=orthospectrum]")
        self.browser.wait("document.querySelector('.card .problem')?.textContent")
        self.assertIn("not enough memory", self.browser.text(".card .problem"))
        self.browser.click("[data-ask=identify]")
        self.browser.wait("document.querySelector('.card')?.textContent.includes('t2g2.8')")


class WithoutGraphics(PageTest):
    def test_numbers_are_there_and_the_reason_is_said(self):
        self.browser.call("Page.addScriptToEvaluateOnNewDocument", source=(
            "HTMLCanvasElement.prototype.getContext = ((old) => function (kind, ...more) {"
            "return kind === 'webgl2' ? null : old.call(this, kind, ...more); })"
            "(HTMLCanvasElement.prototype.getContext);"))
        self.solve(TRIPUS)
        self.browser.wait("document.getElementById('notice')?.textContent")
        self.assertIn("WebGL2 is missing", self.browser.text("#notice"))
        self.assertIn("6.45199027", self.browser.text("#subject-facts"))
        self.browser.click("#about")
        self.assertEqual(self.browser.text("#webgl-state"), "it is missing here")


class Promises(PageTest):
    def test_it_is_one_file_that_asks_for_nothing(self):
        text = page_path().read_text()
        self.assertLess(len(text.encode()), 4e6)
        policy = text.split('Content-Security-Policy"')[1].split('content="')[1].split('"')[0]
        self.assertTrue(policy.startswith("default-src 'none';"))
        self.assertNotIn("connect-src", policy)
        self.assertNotIn("http", policy)

    def test_the_browser_keeps_it_to_that(self):
        self.browser.go()
        refused = self.browser.call("Runtime.evaluate", awaitPromise=True, returnByValue=True, expression=(
            "fetch('http://127.0.0.1:9/').then(() => 'sent', (e) => e.name)"))["result"]["value"]
        self.assertEqual(refused, "TypeError")
        said = [event for event in self.browser.events if event["method"] == "Log.entryAdded"]
        self.assertTrue(any("Content Security Policy" in event["params"]["entry"]["text"] for event in said), said)
        self.browser.events.clear()  # this complaint was wanted

    def test_the_program_hands_it_out(self):
        result = self.run_program("page", "-o", "tripus.html")
        self.assertEqual(result.status, 0, result.err)
        self.browser.go(f"input={TRIPUS}", self.folder / "tripus.html")
        self.browser.solved()
        self.browser.drawn()
