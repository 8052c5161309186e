#!/usr/bin/env python3
"""What people meet around the program: terminals, the man page and the completion of bash.

    scripts/interface_test.py PATH_OF_GRIDSTEP MAN_PAGE BASH_COMPLETION [unittest options]
"""

import fcntl
import json
import os
import pty
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import unittest
from pathlib import Path

PROGRAM = MAN_PAGE = COMPLETION = None

STUDY = {
    "name": "small",
    "sweeps": [
        {
            "shapes": ["disk:radius=5"],
            "estimators": ["ii"],
            "radii": [{"k": 2}],
            "schedule": {"from": 1, "to": 0.1, "steps": 5},
            "shifts": 2,
        }
    ],
}


class Terminal(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="gridstep_")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        (self.folder / "small.json").write_text(json.dumps(STUDY))
        # Foreground is one grey value of a small cube.
        cube = bytes(all(2 <= c <= 5 for c in (x, y, z)) for z in range(8) for y in range(8) for x in range(8))
        (self.folder / "cube.vol").write_bytes(b"X: 8\nY: 8\nZ: 8\nVersion: 2\n.\n" + cube)

    def on_terminal(self, *arguments, columns=40, **environment):
        """What a terminal of so many columns receives, on both streams."""
        try:
            ours, theirs = pty.openpty()
        except OSError as failure:
            self.skipTest(f"no pseudo-terminals here: {failure}")
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        variables = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "TERM")}
        process = subprocess.Popen(
            [PROGRAM, *arguments], cwd=self.folder, stdin=theirs, stdout=theirs, stderr=theirs,
            env={**variables, "TERM": "xterm", **environment},
        )  # fmt: skip
        os.close(theirs)
        received = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            received += piece
        os.close(ours)
        self.assertEqual(process.wait(), 0, received)
        return received.decode().replace("\r\n", "\n")

    COMMANDS = [
        ["--help"],
        ["estimate", "--help"],
        ["study", "--help"],
        ["list"],
        ["study", "small.json"],
        ["study", "level-of-detail", "--volume", "cube.vol", "--radii", "2,1.5", "--out", "detail"],
        ["estimate", "--shape", "ellipse:a=6,b=3", "--h", "0.5", "--estimator", "ii,mdca", "--k", "2"],
        ["estimate", "--volume", "cube.vol", "--radius", "2", "--evaluation", "masks"],
        ["convert", "cube.vol", "cube.nrrd"],
    ]

    def test_no_line_wraps(self):
        for columns in (40, 60, 200):
            for arguments in self.COMMANDS:
                with self.subTest(arguments=arguments, columns=columns):
                    text = self.on_terminal(*arguments, columns=columns)
                    self.assertNotIn("\x1b", text)
                    for line in re.split("[\n\r]", text):
                        # Words that are too long by themselves, such as paths, are not broken.
                        if len(line) >= columns:
                            self.assertLessEqual(len(line.split()), 1, line)

    def test_a_pipe_gets_plain_lines(self):
        for arguments in self.COMMANDS:
            with self.subTest(arguments=arguments):
                result = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, check=True)
                self.assertNotRegex(result.stdout + result.stderr, rb"[\x00-\x09\x0b-\x1f\x7f]")
        table = subprocess.run([PROGRAM, "study", "small.json"], cwd=self.folder, capture_output=True, text=True).stdout
        self.assertRegex(table, "(?m)^shape .* quantity .* verdict$")

    def test_plain_lines_where_they_are_asked_for(self):
        self.assertIn("\r", self.on_terminal("study", "small.json"))
        for plain in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            with self.subTest(plain=plain):
                text = self.on_terminal("study", "small.json", **plain)
                self.assertNotRegex(text, "[\x00-\x09\x0b-\x1f\x7f]")
                self.assertIn("100%", text)
        self.assertIn("\r", self.on_terminal("study", "small.json", NO_COLOR=""), "empty is unset: no-color.org")

    def test_json_is_not_folded(self):
        text = self.on_terminal("list", "studies", "--json")
        self.assertEqual(text, subprocess.run([PROGRAM, "list", "studies", "--json"], capture_output=True, text=True).stdout)


class ManPage(unittest.TestCase):
    def test_has_every_command_and_option(self):
        page = MAN_PAGE.read_text().replace("\\-", "-")
        for command in (None, "list", "study", "estimate", "convert", "report"):
            help_text = subprocess.run([PROGRAM, *filter(None, [command]), "--help"], capture_output=True, text=True).stdout
            options = set(re.findall(r"(?m)^  +(?:-\w,)?(--[\w-]+)", help_text))
            self.assertTrue(options)
            for option in options:
                self.assertIn(option, page)
            if command:
                self.assertIn(f".SS gridstep {command}\n", page)
        self.assertNotIn("--write-man", page)

    def test_readers_do_not_complain(self):
        readers = [["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z"], ["mandoc", "-T", "lint", "-W", "warning"]]
        readers = [reader for reader in readers if shutil.which(reader[0])]
        if not readers:
            self.skipTest("neither man nor mandoc here")
        for reader in readers:
            with self.subTest(reader=reader[0]):
                environment = {**os.environ, "MANROFFSEQ": "", "LC_ALL": "C.UTF-8"}
                result = subprocess.run([*reader, MAN_PAGE], capture_output=True, text=True, env=environment)
                said = (result.stderr if reader[0] == "man" else result.stdout + result.stderr).splitlines()
                # It has none, for the same sources to make the same page.
                self.assertEqual([line for line in said if "missing date" not in line], [])


class Completion(unittest.TestCase):
    def words(self, *typed):
        """What bash proposes for the last of the words typed."""
        script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _gridstep; printf "%s\\n" "${COMPREPLY[@]}"'
        bash = ["bash", "--norc", "-euc", script, "-", str(COMPLETION), "gridstep", *typed]
        result = subprocess.run(bash, capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout.split()

    def setUp(self):
        if not shutil.which("bash"):
            self.skipTest("no bash here")

    def test_words(self):
        listed = json.loads(subprocess.run([PROGRAM, "list", "--json"], capture_output=True, text=True).stdout)
        names = {kind: [entry["name"] for entry in entries] for kind, entries in listed.items()}
        for typed, expected in [
            ([""], ["list", "study", "estimate", "convert", "report", "--help", "--version"]),
            (["est"], ["estimate"]),
            (["list", ""], ["shapes", "estimators", "studies"]),
            (["study", "paper-"], ["paper-2d", "paper-3d"]),
            (["study", "noi"], ["noise"]),
            (["study", "noise", "--ful"], ["--full"]),
            (["study", "noise", "--out", "x"], []),
            (["estimate", "--shape", ""], names["shapes"]),
            (["estimate", "--estimator", ""], names["estimators"]),
            (["estimate", "--shape", "goursat", "--estimator", "mdca,lambda-m"], ["mdca,lambda-mdca", "mdca,lambda-mst"]),
            (["estimate", "--evaluation", ""], ["bricks", "masks", "full"]),
            (["estimate", "--quantity", "no"], ["normal"]),
            (["estimate", "--vol"], ["--volume"]),
            (["estimate", "--volume", "a"], []),
            (["report", "--o"], ["--out"]),
            (["nosuch", "--o"], []),
        ]:
            with self.subTest(typed=typed):
                self.assertEqual(sorted(self.words(*typed)), sorted(expected))
        self.assertEqual(set(names["studies"]) - set(self.words("study", "")), set())

    def test_options_are_those_of_the_help(self):
        for command in ("list", "study", "estimate", "convert", "report"):
            help_text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True).stdout
            options = re.findall(r"(?m)^  +(?:-\w,)?(--[\w-]+)", help_text)
            self.assertEqual(sorted(self.words(command, "--")), sorted(set(options)), command)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    MAN_PAGE, COMPLETION = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve()
    unittest.main()
