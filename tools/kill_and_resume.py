#!/usr/bin/env python3
"""Kills a design at random times, resumes it each time, and compares its files with those of a run that was left alone.

    tools/kill_and_resume.py [DOCUMENT [TIMES]]      default: scene:sheet_design, ten times

Ends with `N passed, N failed`, one for each resumed run. Needs a build of the command line tool and Python's standard library.
"""

import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOOL = os.environ.get("LISSOM_CLI", str(ROOT / "build" / "release" / "lissom"))


def design(document, folder, *more):
    return subprocess.Popen([TOOL, "optimize", document, "-o", str(folder), *more], stdin=subprocess.DEVNULL,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def results(folder):
    """Files that tell no time, by name."""
    return {p.name: p.read_bytes() for p in sorted(folder.glob("*-designed.lissom")) + sorted(folder.glob("*-design.json"))}


def main():
    document = sys.argv[1] if len(sys.argv) > 1 else "scene:sheet_design"
    times = int(sys.argv[2]) if len(sys.argv) > 2 else 10
    chance = random.Random(10)
    passed = failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        whole = Path(scratch) / "whole"
        begin = time.monotonic()
        design(document, whole).communicate()
        seconds = time.monotonic() - begin
        wanted = results(whole)
        if len(wanted) != 2:
            sys.exit(f"{document} made no design")
        print(f"left alone: {seconds:.1f} s", flush=True)
        for number in range(times):
            folder = Path(scratch) / "killed"
            shutil.rmtree(folder, ignore_errors=True)
            run = design(document, folder)
            after = chance.uniform(0, seconds)
            time.sleep(after)
            run.kill()
            run.communicate()
            saved = list(folder.glob("*.checkpoint.json")) if folder.exists() else []
            error = design(document, folder, *(["--resume"] if saved else [])).communicate()[1]
            same = results(folder) == wanted
            passed, failed = passed + same, failed + (not same)
            print(f"{number + 1}: killed after {after:.1f} s, {'resumed' if saved else 'begun anew'}: "
                  f"{'the same bytes' if same else 'OTHER BYTES ' + error}", flush=True)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


main()
