#!/usr/bin/env python3
"""Checks who includes whom, and a few other rules that a compiler does not see.

    tools/check_layers.py [ROOT]      ROOT: the repository, by default the one this script is in

One line per finding, `file:line: rule: what is wrong; what to do`. Warnings do not fail the check.
Needs Python's standard library only. tools/check_layers_test.py proves that each rule catches its mistake.
"""

import fnmatch
import re
import sys
from pathlib import Path

# A file includes its own folder and lower ranks; equal ranks do not see each other.
RANKS = {
    "core": 0,
    "geometry": 1,
    "model": 2,
    "mechanics": 3,
    "equilibrium": 4,
    "motion": 5,
    "design": 5,
    "posing": 5,
    "fabrication": 6,
    "view": 6,
    "session": 7,
    "editing": 8,
    "studio": 9,
}
SCENES_HIGHEST_RANK = 5
ROOTS = ("lissom", "scenes", "apps", "bindings", "tests", "bench")
SEES_SCENES = ("scenes", "apps", "tests", "bench")

# Headers that only some files may include: (name of the rule, header, files that may, remedy).
CONFINED = [
    ("json", re.compile(r"^nlohmann/"), ("lissom/model/*_json.*", "lissom/session/*", "lissom/editing/*", "lissom/studio/*", "tests/*"),
     "read and write JSON in lissom/model/*_json.cpp or in lissom/session, lissom/editing and lissom/studio"),
    ("sparse-solver", re.compile(r"^(suitesparse/)?(cholmod|umfpack|amd|camd|colamd|metis|SuiteSparse)\w*\.h$"),
     ("lissom/core/linear_solver*.cpp",), "go through lissom/core/linear_solver.h"),
    ("blas-threads", re.compile(r"^(cblas\S*|openblas\S*|omp)\.h$"),
     (), "use ThreadPool of lissom/core/parallel.h and Eigen"),
    ("iostream", re.compile(r"^(iostream|print)$"), ("apps/*", "bindings/*", "tests/*", "bench/*"),
     "return text, or report through Context; only apps print"),
    ("system", re.compile(r"^(unistd|fcntl|signal|dlfcn|pthread|windows|io|direct)\.h$|^sys/|^csignal$"),
     ("lissom/core/file_io.cpp", "apps/*", "bindings/*", "tests/*", "bench/*"),
     "use the standard library, or put what depends on the system in lissom/core/file_io.cpp"),
]

LINES_WARN, LINES_MAX = 300, 500
SOURCE_SUFFIXES = (".h", ".cpp", ".py", ".sh", ".ts", ".tsx")
TEXT_SUFFIXES = SOURCE_SUFFIXES + (".cmake", ".txt", ".json", ".md", ".in", ".lissom")
SKIPPED_FOLDERS = ("out", "node_modules", "coverage", "dist", "shots", "__pycache__", ".git", ".cache")  # and everything that starts with "build"
MARKS = re.compile(r"\b(" + "|".join(("TO" "DO", "FIX" "ME", "XX" "X", "HA" "CK")) + r")\b")
MACHINE_PATH = re.compile(r"(?<![\w.}/-])/(?:work|root|home|Users|tmp/bash_jobs)[\w.]*/|\b[A-Z]:\\\\?Users")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


class Findings:
    def __init__(self):
        self.errors, self.warnings = [], []

    def error(self, file, line, rule, text, remedy):
        self.errors.append(f"{file}:{line}: {rule}: {text}; {remedy}")

    def warn(self, file, line, rule, text, remedy):
        self.warnings.append(f"{file}:{line}: warning: {rule}: {text}; {remedy}")


def allowed(file, patterns):
    return any(fnmatch.fnmatchcase(file, p) for p in patterns)


def check_folder(file, found):
    parts = file.split("/")
    if parts[0] == "lissom" and (len(parts) < 3 or parts[1] not in RANKS):
        found.error(file, 1, "folder", "it is in no folder of a known rank",
                    "move it, or give its folder a rank in tools/check_layers.py")
        return False
    return True


def check_own_include(root, file, line, target, found):
    """An include in quotes: it has to be ours, written from the root, and of a lower rank."""
    here, there = file.split("/"), target.split("/")
    if there[0] not in ROOTS or ".." in there:
        found.error(file, line, "rooted", f'"{target}" is not written from the root of the repository',
                    'write #include "lissom/core/result.h" for ours and <...> for everybody else\'s')
        return
    if not (root / target).is_file():
        found.error(file, line, "rooted", f'"{target}" does not exist', "correct the path")
        return
    if there[0] in ("tests", "apps", "bench", "bindings"):
        tested = (here[0], there[0]) == ("tests", "bench") or (here[:2], there[:2]) == (["tests", "studio"], ["apps", "studio"])
        if here[0] != there[0] and not tested:
            found.error(file, line, "layer", f"{there[0]}/ is included from outside",
                        f"move what is shared out of {there[0]}/")
        return
    if there[0] == "scenes":
        if here[0] not in SEES_SCENES:
            found.error(file, line, "layer", f"{here[0]}/ includes scenes/",
                        "only tests, bench and apps use scenes; pass a Model instead")
        return
    if len(there) < 3 or there[1] not in RANKS:
        return  # reported where the file is
    rank = RANKS[there[1]]
    if here[0] == "scenes" and rank > SCENES_HIGHEST_RANK:
        found.error(file, line, "layer", f"scenes/ includes lissom/{there[1]} (rank {rank})",
                    f"scenes use ranks 0 to {SCENES_HIGHEST_RANK}")
    if here[0] == "lissom" and here[1] != there[1] and rank >= RANKS[here[1]]:
        found.error(file, line, "layer",
                    f"lissom/{here[1]} (rank {RANKS[here[1]]}) includes lissom/{there[1]} (rank {rank})",
                    "a file sees its own folder and lower ranks; move the shared part down or turn the call around")


def check_foreign_include(file, line, target, found):
    if target.split("/")[0] in ROOTS:
        found.error(file, line, "rooted", f"<{target}> is ours", "write it in quotes")
        return
    for rule, header, files, remedy in CONFINED:
        if header.search(target) and not allowed(file, files):
            found.error(file, line, rule, f"<{target}> is included here", remedy)
            return
    standard = "/" not in target and "." not in target
    eigen = target.startswith(("Eigen/", "unsupported/Eigen/"))
    at_home = file.endswith("_json.h") or file.startswith(("lissom/editing/", "lissom/studio/"))  # not installed
    if file.startswith("lissom/") and file.endswith(".h") and not at_home and not (standard or eigen):
        found.error(file, line, "public-header", f"<{target}> is needed by everyone who includes this header",
                    "headers of the library need the standard library and Eigen only; include it in the .cpp")


def check_cpp(root, file, lines, found):
    if not check_folder(file, found):
        return
    for number, text in enumerate(lines, 1):
        match = INCLUDE.match(text)
        if match and match[1] == '"':
            check_own_include(root, file, number, match[2], found)
        elif match:
            check_foreign_include(file, number, match[2], found)
    if file.endswith(".h") and not any(text.strip() == "#pragma once" for text in lines):
        found.error(file, 1, "pragma-once", "the header has no #pragma once", "add it as the first line")


def check_text(file, lines, found):
    for number, text in enumerate(lines, 1):
        mark = MARKS.search(text)
        if mark:
            found.error(file, number, "mark", f"'{mark[0]}' is left over", "settle it, or open an issue")
        path = MACHINE_PATH.search(text)
        if path:
            found.error(file, number, "machine-path", f"'{path[0].strip()}' exists on one machine only",
                        "use a path relative to the repository")
    if file.endswith(SOURCE_SUFFIXES):
        if len(lines) > LINES_MAX:
            found.error(file, LINES_MAX + 1, "length", f"{len(lines)} lines", f"split it; the limit is {LINES_MAX}")
        elif len(lines) > LINES_WARN:
            found.warn(file, LINES_WARN + 1, "length", f"{len(lines)} lines",
                       f"files rarely pass {LINES_WARN}; look for a seam")


def texts(root):
    """Every text file of ours, as (path from the root, lines)."""
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        skipped = relative.parts[0].startswith("build") or any(part in SKIPPED_FOLDERS for part in relative.parts)
        if skipped or not path.is_file():
            continue
        if path.suffix in TEXT_SUFFIXES or path.name == "Makefile" or relative.as_posix() == ".ci/run":
            try:
                yield relative.as_posix(), path.read_text(encoding="utf-8").splitlines()
            except UnicodeDecodeError:
                continue  # a test document that is broken on purpose


def check(root):
    """Returns (findings, number of C++ files looked at)."""
    found, count = Findings(), 0
    for file, lines in texts(root):
        check_text(file, lines, found)
        if file.split("/")[0] in ROOTS and file.endswith((".h", ".cpp")) and not file.startswith("tests/install/"):
            count += 1
            check_cpp(root, file, lines, found)
    return found, count


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found, count = check(root)
    if count == 0:
        print(f"check_layers: no C++ files under {root.name}/", file=sys.stderr)
        return 1
    for line in found.warnings + found.errors:
        print(line)
    print(f"check_layers: {count} C++ files, {len(found.errors)} errors, {len(found.warnings)} warnings")
    return 1 if found.errors else 0


if __name__ == "__main__":
    sys.exit(main())
