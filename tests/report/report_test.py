#!/usr/bin/python3
"""tools/report makes a page of whatever the tests left: good, bad or broken."""
import json
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
           "gl_errors": [], "limits": {}, "baseline_driver": True, "renderer": "llvmpipe", "gl_version": "4.5"}
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
        self.assertIn("pictures: 1 of 1 differ", page)
        self.assertIn("why", page)
        self.assertIn("gt²/2 &lt;.", page)
        self.assertIn("<svg", page)

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
