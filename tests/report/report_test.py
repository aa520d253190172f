#!/usr/bin/python3
"""tools/report makes a page of whatever the tests left: good, bad or broken."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

REPORT = Path(__file__).resolve().parents[2] / "tools/report"
PLOT = {"title": "fall", "x": {"label": "t", "unit": "s"}, "y": {"label": "y", "unit": "m"},
        "series": [{"label": "cpu", "points": [[0, 0], [1, -4.9]]}]}
STUDY = {"name": "fall", "title": "Free fall", "claim": "A body falls by gt²/2 <.", "plots": [PLOT],
         "figures": [{"what": "height", "measured": -4.9, "expected": -4.905, "unit": "m", "tolerance": 0.01,
                      "relative": False, "holds": True}]}
PICTURE = {"name": "wood", "scene": "wood", "frame": 3, "verdict": "missing baseline", "holds": False, "sentence": "none",
           "accept": "tools/update-baselines wood", "gl_errors": [], "limits": {}, "baseline_driver": True, "renderer": "llvmpipe", "gl_version": "4.5"}
STATE = {"scene": "wood", "solver": "cpu", "driver": "Linux", "verdict": "different", "sentence": "step 7",
         "accept": "tools/update-states wood"}


class Report(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)

    def leave(self, name, contents):
        path = Path(self.place.name, name)
        path.parent.mkdir(exist_ok=True)
        path.write_text(contents if isinstance(contents, str) else json.dumps(contents), encoding="utf-8")

    def make(self):
        run = subprocess.run([REPORT, self.place.name], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return Path(self.place.name, "index.html").read_text(encoding="utf-8")

    def test_nothing_there_is_said(self):
        run = subprocess.run([REPORT, self.place.name], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("nothing is in", run.stderr)

    def test_failures_come_first_with_what_accepts_them(self):
        self.leave("physics/fall.json", STUDY)
        self.leave("pictures/wood.json", PICTURE)
        self.leave("pictures/wood-actual.png", "not looked into")
        self.leave("states/cpu-wood.json", STATE)
        self.leave("ctest.xml", '<testsuite><testcase name="bad" time="1"><failure/><system-out>why</system-out>'
                                '</testcase></testsuite>')
        page = self.make()
        self.assertLess(page.index("tools/update-baselines wood"), page.index("Free fall"))
        self.assertLess(page.index("tools/update-states wood"), page.index("Free fall"))
        self.assertIn("pictures: 1 of 1 fail", page)
        self.assertIn("why", page)
        self.assertIn("gt²/2 &lt;.", page)
        self.assertIn("<svg", page)

    def test_gl_errors_are_shown_and_nothing_accepts_them(self):
        self.leave("pictures/wood.json", PICTURE | {"verdict": "GL errors", "accept": "", "gl_errors": ["invalid <enum>"]})
        self.leave("pictures/wood-actual.png", "not looked into")
        page = self.make()
        self.assertIn("invalid &lt;enum&gt;", page)
        self.assertNotIn("update-baselines", page)

    def test_another_driver_is_not_told_to_renew(self):
        self.leave("pictures/wood.json", PICTURE | {"baseline_driver": False})
        page = self.make()
        self.assertNotIn("tools/update-baselines", page)
        self.assertIn("did not make the baselines", page)

    def test_skipped_tests_are_counted_apart(self):
        self.leave("ctest.xml", """<testsuite>
            <testcase name="good" time="1" status="run"><system-out/></testcase>
            <testcase name="other" time="0" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
              <system-out>no stored states</system-out></testcase>
            <testcase name="off" time="0" status="disabled"/></testsuite>""")
        page = self.make()
        self.assertIn("tests: 1 passed; 2 tests skipped", page)
        self.assertIn("no stored states", page)
        self.assertNotIn('id="failed"', page)

    def test_a_test_that_could_not_start_has_failed(self):
        self.leave("ctest.xml", '''<testsuite><testcase name="gone" time="0" status="notrun">
            <skipped message="Unable to find executable"/></testcase></testsuite>''')
        page = self.make()
        self.assertIn("tests: 1 of 1 failed", page)
        self.assertIn('id="failed"', page)

    def test_the_driver_is_known_without_pictures(self):
        self.leave("states/a.json", STATE | {"driver": "llvmpipe 7"})
        self.leave("physics/fall.json", STUDY | {"driver": "Linux <x>"})
        self.assertIn("Driver Linux &lt;x&gt;; llvmpipe 7.", self.make())
        self.leave("pictures/wood.json", PICTURE)
        self.assertIn("Driver llvmpipe, OpenGL 4.5.", self.make())

    def test_a_commit_that_is_not_the_one_noted_is_said(self):
        self.leave("states/a.json", STATE)
        self.assertIn("Commit not noted", self.make())
        self.leave("commit.txt", "0000000, An old one\n")
        self.assertRegex(self.make(), r"began: 0000000, An old one\.<br>Commit now: (?!0000000)")

    def test_results_of_a_later_run_than_the_list_of_tests_are_said(self):
        self.leave("states/a.json", STATE)
        self.leave("ctest.xml", "<testsuite/>")
        state, tests = (Path(self.place.name, name) for name in ("states/a.json", "ctest.xml"))
        os.utime(state, (100, 100))
        os.utime(tests, (101, 101))
        self.assertNotIn("of an earlier run", self.make())
        os.utime(state, (102, 102))
        self.assertIn("of an earlier run", self.make())

    def test_start_removes_what_was_left_and_notes_the_commit(self):
        self.leave("states/a.json", STATE)
        self.leave("ctest.xml", "<testsuite/>")
        noted = self.start()
        self.assertEqual([path.name for path in Path(self.place.name).iterdir()], ["commit.txt"])
        page = self.make()
        self.assertIn("Nothing was tested", page)
        if self.start() == noted:  # nobody works on the checkout meanwhile
            self.assertNotIn("Commit now", page)

    def start(self):
        subprocess.run([REPORT, "--start", self.place.name], check=True)
        return Path(self.place.name, "commit.txt").read_text(encoding="utf-8")

    def test_broken_files_become_sentences(self):
        self.leave("physics/cut.json", '{"name": "cu')
        self.leave("physics/empty.json", {"name": "empty"})
        self.leave("physics/number.json", 7)
        self.leave("physics/odd.json", STUDY | {"name": "odd", "plots": [{"title": "half"}],
                                                "figures": [{"what": "x", "measured": "?"}]})
        self.leave("physics/types.json", STUDY | {"plots": 3})
        self.leave("pictures/wood.json", PICTURE | {"limits": 3})
        self.leave("states/a.json", [])
        self.leave("ctest.xml", "<testsuite>")
        page = self.make()
        for name in ("cut.json", "empty.json", "number.json", "odd.json", "types.json", "wood.json", "a.json",
                     "ctest.xml"):
            self.assertRegex(page, f"{name} cannot be (shown|drawn)", name)

    def test_the_page_needs_nothing_else(self):
        self.leave("physics/fall.json", STUDY)
        page = self.make()
        self.assertNotRegex(page, r"<script|<link|src=.http|@import")


if __name__ == "__main__":
    unittest.main()
