#!/usr/bin/env python3
"""Runs tests of the studio that are written in TypeScript and ends with one line, `N passed, N failed`.

    tools/page_tests.py apps/studio/page          those of the page, without a browser
    tools/page_tests.py tests/studio/x_test.ts    of the whole studio in Chromium; LISSOM_CLI is the tool's path

Both run under Vitest with the packages of apps/studio/page. Every test counts; one that is skipped, or a run without any,
counts as failed. Needs Python's standard library only.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "apps" / "studio" / "page"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


def command(target, report):
    """The words of the run: of the page's folder, or of one file below tests/studio."""
    words = ["vitest", "run", "--reporter=default", "--reporter=json", f"--outputFile={report}"]
    if target == PAGE:
        return words
    return words + ["--root", str(target.parent), "--config", str(target.parent / "vitest.config.mts"), target.name]


def count(report):
    """(passed, [names of those that did not]) of a report."""
    passed, bad = 0, []
    for file in report["testResults"]:
        name = Path(file["name"]).name
        if file["status"] != "passed" and not file["assertionResults"]:
            bad.append(f"{name}: {file['message'].strip() or 'no test in it'}")
        for case in file["assertionResults"]:
            if case["status"] == "passed":
                passed += 1
            else:
                bad.append(f"{name}: {case['fullName']} ({case['status']})")
    return passed, bad


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    target = Path(sys.argv[1]).resolve()
    if target != PAGE and not any(map(shutil.which, BROWSERS)):
        print("tools/page_tests.py: no browser is installed; run tools/setup.sh test", file=sys.stderr)
        print("0 passed, 1 failed")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        done = subprocess.run(["tools/page.sh", "run", *command(target, report)], cwd=ROOT, stdin=subprocess.DEVNULL, check=False)
        passed, bad = count(json.loads(report.read_text(encoding="utf-8"))) if report.exists() else (0, ["Vitest wrote no report"])
    if passed == 0 and not bad:
        bad.append("no test was run")
    if done.returncode and not bad:
        bad.append(f"Vitest ended with exit code {done.returncode} although its tests passed")
    for name in bad:
        print(f"FAIL {name}")
    print(f"{passed} passed, {len(bad)} failed")
    return 1 if bad else 0


sys.exit(main())
