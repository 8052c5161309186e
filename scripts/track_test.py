#!/usr/bin/env python3
"""Plants slow-downs, more work, lost benchmarks and failures in made-up benchmark programs, and sees what track says."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TRACK = pathlib.Path(__file__).resolve().parent / "track"

# Behaves as a Google Benchmark program; its times come in turn from a list, one a process.
PROGRAM = """#!{python}
import json, pathlib, re, sys
rows = {rows}
options = dict(a.lstrip("-").partition("=")[::2] for a in sys.argv[1:])
rows = [r for r in rows if re.search(options["benchmark_filter"], r["name"])]
if "benchmark_list_tests" in options:
    print(*(r["name"] for r in rows), sep="\\n")
    sys.exit()
if {status}:
    print("it broke", file=sys.stderr)
    sys.exit({status})
state = pathlib.Path(__file__ + ".count")
number = int(state.read_text()) if state.exists() else 0
state.write_text(str(number + 1))
for r in rows:
    times = r.pop("times")
    r.update(cpu_time=times[number % len(times)], real_time=times[0], time_unit="us", run_type="iteration")
print(json.dumps(dict(context=dict(num_cpus=2), benchmarks=rows)))
"""


def row(name, times, **counters):
    return {"name": name, "times": times, **counters}


class Track(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="gridstep_track_")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def program(self, side, rows, status=0, name="some_bench"):
        path = self.folder / side / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(PROGRAM.format(python=sys.executable, rows=repr(rows), status=status))
        path.chmod(0o755)

    def track(self, *options):
        return subprocess.run(
            [sys.executable, TRACK, "--programs", self.folder / "base", self.folder / "head", "--rounds", "3", *options],
            capture_output=True, text=True,
        )

    def verdicts(self, base, head, code, *options):
        self.program("base", base)
        self.program("head", head)
        result = self.track("--json", self.folder / "out", *options)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        rows = json.loads((self.folder / "out" / "verdicts.json").read_text())
        for r in rows:
            self.assertRegex(result.stdout, rf"(?m)^{r['name']} .*{r['verdict']}")
        return {r["name"]: r["verdict"] for r in rows}

    def test_a_planted_slow_down_is_seen_and_warns(self):
        base = [row("a", [100, 101, 99]), row("b", [100, 101, 99]), row("c", [100, 101, 99])]
        head = [row("a", [120, 121, 119]), row("b", [80, 81, 79]), row("c", [101, 100, 102])]
        found = self.verdicts(base, head, 0)
        self.assertEqual(found, {"a": "slower", "b": "faster", "c": "same"})
        self.verdicts(base, head, 3, "--strict")

    def test_both_bounds_and_the_spread_must_be_exceeded(self):
        base = [row("spread", [100, 130, 100]), row("small", [1.0, 1.0, 1.0]), row("slight", [1000, 1001, 999])]
        head = [row("spread", [125, 126, 127]), row("small", [1.8, 1.8, 1.8]), row("slight", [1030, 1031, 1029])]
        self.assertEqual(set(self.verdicts(base, head, 0).values()), {"same"})
        bounds = ("--absolute", "100", "--relative", "0.01")
        found = self.verdicts(base, head, 0, *bounds)
        self.assertEqual(found, {"spread": "same", "small": "slower", "slight": "slower"})

    def test_work_decides_whatever_the_clock_says(self):
        base = [row("a", [100], cells_visited=1000), row("b", [100], cells_visited=1000), row("c", [100], boxes=5)]
        head = [row("a", [50], cells_visited=1100), row("b", [100], cells_visited=900), row("c", [100], boxes=5)]
        found = self.verdicts(base, head, 3)
        self.assertEqual(found, {"a": "more", "b": "less", "c": "same"})
        self.verdicts(base, [base[0], head[1], head[2]], 0)

    def test_a_lost_benchmark_is_no_data(self):
        base = [row("a", [100]), row("b", [100])]
        self.assertEqual(self.verdicts(base, base[:1], 4), {"a": "same", "b": "no data"})
        self.assertEqual(self.verdicts(base[:1], base, 0), {"a": "same", "b": "no data"}, "a new one is no fault")
        broken = [base[0], row("b", [100], error_occurred=True)]
        self.assertEqual(self.verdicts(base, broken, 4), {"a": "same", "b": "no data"})
        self.verdicts(base, broken, 0, "--filter", "^a$")

    def test_a_regression_is_worse_than_lost_data(self):
        base = [row("a", [100], cells_visited=10), row("b", [100])]
        self.verdicts(base, [row("a", [100], cells_visited=20)], 3)

    def test_failures_are_told_in_one_line(self):
        self.program("base", [row("a", [100])])
        self.program("head", [row("a", [100])], status=7)
        result = self.track()
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"(?m)^track: .*some_bench.* failed: it broke$")
        self.assertEqual(self.track("--filter", "nothing").returncode, 4)
        (self.folder / "head" / "some_bench").unlink()
        self.assertRegex(self.track().stderr, r"track: .*head: no benchmark programs there")
        self.assertEqual(self.track("--rounds", "1").returncode, 2)

    def test_json_is_google_benchmarks(self):
        self.verdicts([row("a", [100, 110, 120])], [row("a", [100])], 0)
        base = json.loads((self.folder / "out" / "base.json").read_text())
        self.assertEqual([r["cpu_time"] for r in base["benchmarks"]], [100, 110, 120])
        self.assertEqual([r["repetition_index"] for r in base["benchmarks"]], [0, 1, 2])
        for key in ("num_cpus", "cpu", "revision"):
            self.assertIn(key, base["context"])

    def test_the_history_only_grows_and_has_a_page(self):
        history = self.folder / "h" / "history.jsonl"
        for time in (100, 300):
            self.verdicts([row("a<b", [100])], [row("a<b", [time])], 0, "--history", history)
        lines = history.read_text().splitlines()
        self.assertEqual([json.loads(line)["ns"]["a<b"] for line in lines], [100e3, 300e3])
        page = history.with_suffix(".html").read_text()
        self.assertIn("a&lt;b", page)
        self.assertIn("+200.0 %", page)
        self.assertNotIn("http", page.replace("http-equiv", ""), "it needs no network")


if __name__ == "__main__":
    unittest.main()
