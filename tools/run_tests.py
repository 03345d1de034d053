#!/usr/bin/env python3
"""Runs the tests of a build and ends with one line, `N passed, N failed`.

    tools/run_tests.py BUILD_DIR [--labels unit,derivatives] [--verify] [--jobs N]

What is counted: every GoogleTest case; every script check as one, or as many as its own last line says; with --verify,
every line of `lissom verify tests/physics/*`. A program that crashes, writes no report or runs no case is a failure; so
is a run in which no GoogleTest case was run. Skipped cases are named with their reason and count as nothing, for they
prove nothing; one without a reason is a failure.
Needs Python's standard library only.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SUMMARY = re.compile(r"^(\d+) passed, (\d+) failed$")


class Tally:
    def __init__(self):
        self.passed, self.failed, self.cases = 0, 0, 0

    def fail(self, text, count=1):
        print(f"FAIL {text}")
        self.failed += count


def count_report(name, path, output, tally):
    """Adds the cases of one GoogleTest report; returns how many of them did not pass. `output` is what the program said."""
    report = json.loads(path.read_text(encoding="utf-8"))
    bad = ran = skipped = 0
    for suite in report["testsuites"]:
        for case in suite["testsuite"]:
            title = f"{name}: {suite['name']}.{case['name']}"
            if case.get("result") == "SKIPPED":
                # Only where data from outside the repository is missing: said with its reason, and not counted as passed.
                reasons = re.findall(r": Skipped\n(.+)\n", output)
                if reasons:
                    print(f"SKIP {title}: {reasons[min(skipped, len(reasons) - 1)]}")
                    skipped += 1
                else:
                    tally.fail(f"{title} was skipped without a reason")
                    bad += 1
                continue
            if case["status"] != "RUN":
                tally.fail(f"{title} did not run")
                bad += 1
                continue
            ran += 1
            if case.get("failures"):
                tally.fail(title)
                bad += 1
            else:
                tally.passed += 1
    tally.cases += ran
    if ran == 0 and bad == 0 and skipped == 0:
        tally.fail(f"{name}: no test case in it")
        bad += 1
    return bad


def run_ctest(build, labels, jobs, tally):
    reports, junit = build / "reports", build / "ctest.xml"
    shutil.rmtree(reports, ignore_errors=True)
    junit.unlink(missing_ok=True)
    command = ["ctest", "--test-dir", str(build), "-j", str(jobs), "--output-on-failure", "--output-junit", str(junit)]
    if labels:
        command += ["-L", "^(" + "|".join(labels) + ")$"]
    subprocess.run(command, check=False, stdin=subprocess.DEVNULL)
    if not junit.exists():
        tally.fail("ctest wrote no report")
        return
    for test in ElementTree.parse(junit).iter("testcase"):
        name, ok = test.get("name"), test.get("status") == "run"
        report = reports / f"{name}.json"
        if report.exists():
            bad = count_report(name, report, test.findtext("system-out") or "", tally)
            if not ok and bad == 0:
                tally.fail(f"{name} ended badly although its cases passed")
            continue
        lines = (test.findtext("system-out") or "").rstrip().splitlines()
        counts = SUMMARY.match(lines[-1].strip()) if lines else None
        if counts:
            passed, failed = int(counts[1]), int(counts[2])
            tally.passed += passed
            if failed:
                tally.fail(f"{name}: {failed} of {passed + failed}", failed)
            if not ok and failed == 0:
                tally.fail(f"{name} ended badly although its checks passed")
        elif ok and not (build / "tests" / name).exists():
            tally.passed += 1
        else:
            tally.fail(f"{name} wrote no report" if ok else name)


def run_verify(build, tally):
    """`lissom verify` over the reference documents; its PASS and FAIL lines count."""
    tool = build / "lissom"
    documents = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "tests/physics").glob("*.lissom"))
    if not documents or not tool.exists():
        return
    print(f"== lissom verify: {len(documents)} documents", flush=True)
    done = subprocess.run([str(tool), "verify", *documents], cwd=ROOT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, text=True, check=False)
    print(done.stdout, end="")
    lines = done.stdout.splitlines()
    passed = sum(line.startswith("PASS") for line in lines)
    failed = sum(line.startswith("FAIL") for line in lines)
    tally.passed += passed
    tally.failed += failed
    if passed + failed == 0:
        tally.fail("lissom verify checked nothing")
    elif (done.returncode == 0) != (failed == 0):
        tally.fail(f"lissom verify ended with exit code {done.returncode} and {failed} failed lines")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--labels", default="", help="folders of tests/, comma separated; default: all")
    parser.add_argument("--verify", action="store_true", help="also run the documents of tests/physics")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    build, tally = options.build.resolve(), Tally()
    run_ctest(build, [label for label in options.labels.split(",") if label], options.jobs, tally)
    if options.verify:
        run_verify(build, tally)
    if tally.cases == 0:
        tally.fail("no test case was run")
    print(f"{tally.passed} passed, {tally.failed} failed")
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())
