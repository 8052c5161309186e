#!/usr/bin/env python3
"""Checks who includes whom: a folder is a layer, and an estimator never sees the answer key (shapes/analytic).

    check_layers.py [ROOT]       report every forbidden include and every cycle; exit 1 if there is any
    check_layers.py --selftest   plant each kind of mistake in a copy, and see that it is reported

Tests (*_test.cpp, *_fuzz.cpp) and their helpers (testing_*.hpp) may include all of shapes/ and estimators/ besides what their
folder may: they compare with the answer key. Nothing else may include a helper of tests.
"""

import re
import shutil
import sys
import tempfile
from pathlib import Path

SHAPES = {"shapes", "shapes/analytic", "shapes/digital", "shapes/files", "shapes/base"}
LIBRARY = SHAPES | {"estimators"}
# A folder not listed belongs to the layer of its parent. A layer may always include itself.
MAY_INCLUDE = {
    "shapes/base": set(),
    "shapes/digital": {"shapes/base"},
    "shapes/files": {"shapes/digital", "shapes/base"},
    "shapes/analytic": {"shapes/base"},
    "shapes": {"shapes/analytic", "shapes/digital", "shapes/base"},  # the scene: where both meet
    "estimators": {"shapes/digital", "shapes/base"},  # never shapes/analytic nor the scene: the answer key
    "experiments/core": LIBRARY,
    "experiments": LIBRARY | {"experiments/core"},
    "experiments/report": LIBRARY | {"experiments", "experiments/core"},
    "experiments/program": LIBRARY | {"experiments", "experiments/core", "experiments/report"},
    "bench": LIBRARY | {"experiments", "experiments/core"},  # not the program: its library is measured
}
TOP_FOLDERS = sorted({layer.split("/")[0] for layer in MAY_INCLUDE})
SUFFIXES = {".hpp", ".ipp", ".inc", ".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')


def layer_of(path):
    for folder in path.parents:
        if folder.as_posix() in MAY_INCLUDE:
            return folder.as_posix()
    return None


def is_test(path):
    return path.name.endswith(("_test.cpp", "_fuzz.cpp")) or path.name.startswith("testing_")


def includes_of(root, path):
    """(line, path relative to root) of each include of a file of ours, found as the compiler finds it."""
    for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        for candidate in ((root / path).parent / match[1], root / match[1]):
            if candidate.is_file() and candidate.resolve().is_relative_to(root):
                yield number, candidate.resolve().relative_to(root)
                break


def cycles(graph):
    """One cycle for each edge that closes one in a depth-first walk: empty exactly if the graph has none."""
    found, done, trail = [], set(), []

    def walk(node):
        if node in trail:
            found.append(trail[trail.index(node):] + [node])
        elif node not in done:
            trail.append(node)
            for other in sorted(graph.get(node, ())):
                walk(other)
            trail.pop()
            done.add(node)

    for node in sorted(graph):
        walk(node)
    return found


def check(root):
    root = root.resolve()
    problems, files, folders = [], {}, {}
    for path in sorted(p.relative_to(root) for top in TOP_FOLDERS for p in (root / top).rglob("*")
                       if p.suffix in SUFFIXES):
        layer = layer_of(path)
        allowed = MAY_INCLUDE[layer] | {layer} | (LIBRARY if is_test(path) else set())
        for number, target in includes_of(root, path):
            where = f"{path.as_posix()}:{number}"
            if layer_of(target) not in allowed:
                problems.append(f"{where}: {layer} may not include {target.as_posix()}")
            elif is_test(target) and not is_test(path):
                problems.append(f"{where}: {target.as_posix()} is for tests alone")
            files.setdefault(path.as_posix(), set()).add(target.as_posix())
            # A catalogue and the subfolders of what it lists are one family. Tests are nobody's dependency.
            source, other = path.parent, target.parent
            family = layer == layer_of(target) and (source in other.parents or other in source.parents)
            if source != other and not family and not is_test(path):
                folders.setdefault(source.as_posix(), set()).add(other.as_posix())
    for kind, graph in (("folders", folders), ("files", files)):
        problems += [f"cycle of {kind}: {' -> '.join(cycle)}" for cycle in cycles(graph)]
    return problems


def selftest(root):
    plants = [  # files to write, and all that has to be reported
        ({}, []),
        ({"estimators/planted.cpp": '\n\n#include "shapes/analytic/shape.hpp"\n'},
         ["estimators/planted.cpp:3: estimators may not include shapes/analytic/shape.hpp"]),
        ({"estimators/deep/planted.ipp": '# include <../../shapes/analytic/shape.hpp>\n'},
         ["estimators/deep/planted.ipp:1: estimators may not include shapes/analytic/shape.hpp"]),
        ({"estimators/planted.cpp": '#include "shapes/scene.hpp"\n'},
         ["estimators/planted.cpp:1: estimators may not include shapes/scene.hpp"]),
        ({"shapes/digital/planted.cpp": '#include "shapes/analytic/shape.hpp"\n'},
         ["shapes/digital/planted.cpp:1: shapes/digital may not include shapes/analytic/shape.hpp"]),
        ({"bench/planted.cpp": '#include "experiments/program/planted.hpp"\n', "experiments/program/planted.hpp": ""},
         ["bench/planted.cpp:1: bench may not include experiments/program/planted.hpp"]),
        ({"estimators/planted_test.cpp": '#include "shapes/analytic/shape.hpp"\n#include "testing_planted.hpp"\n',
          "estimators/testing_planted.hpp": '#include "shapes/scene.hpp"\n'}, []),
        ({"estimators/planted_test.cpp": '#include "experiments/planted.hpp"\n', "experiments/planted.hpp": ""},
         ["estimators/planted_test.cpp:1: estimators may not include experiments/planted.hpp"]),
        ({"bench/planted.cpp": '#include "estimators/testing_planted.hpp"\n', "estimators/testing_planted.hpp": ""},
         ["bench/planted.cpp:1: estimators/testing_planted.hpp is for tests alone"]),
        ({"bench/a.hpp": '#include "b.hpp"\n', "bench/b.hpp": '#include "bench/a.hpp"\n'},
         ["cycle of files: bench/a.hpp -> bench/b.hpp -> bench/a.hpp"]),
        ({"estimators/p/a.hpp": '#include "estimators/q/b.hpp"\n', "estimators/q/b.hpp": "",
          "estimators/q/c.hpp": '#include "estimators/p/d.hpp"\n', "estimators/p/d.hpp": ""},
         ["cycle of folders: estimators/p -> estimators/q -> estimators/p"]),
    ]
    failures, before = 0, check(root)
    for files, expected in plants:
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder)
            for top in TOP_FOLDERS:
                if (root / top).is_dir():
                    shutil.copytree(root / top, copy / top)
            for name, text in files.items():
                (copy / name).parent.mkdir(parents=True, exist_ok=True)
                (copy / name).write_text(text, encoding="utf-8")
            reported = [problem for problem in check(copy) if problem not in before]
        if reported != expected:
            failures += 1
            print(f"planted {files}\n  expected {expected}\n  reported {reported}", file=sys.stderr)
    print(f"{len(plants) - failures} of {len(plants)} plants as expected")
    return failures


def main(arguments):
    root = Path(__file__).resolve().parent.parent
    if arguments == ["--selftest"]:
        return 1 if selftest(root) else 0
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__)
        return 0 if arguments[0] in ("-h", "--help") else 2
    problems = check(Path(arguments[0]) if arguments else root)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
