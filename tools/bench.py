#!/usr/bin/env python3
"""Runs the benches of a build and writes BUILD_DIR/../bench.json and a table.

    tools/bench.py BUILD_DIR [NAME...]      NAME: programs of bench/; default: all

Each row is {name, metric, value, unit}. Programs that use Google Benchmark report by themselves: times are wall time per
iteration, the median when a bench repeats itself, and a counter names its unit in brackets, counters["peak memory [MB]"].
Programs with a main() of their own print a line `name TAB metric TAB value TAB unit` for each row, besides what people
read. A program that ends badly or measures nothing is a failure. Needs Python's standard library only.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FIELDS = ("name", "metric", "value", "unit")
# What Google Benchmark writes about a run besides the counters of the bench itself.
FIXED = {
    "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions", "repetition_index",
    "threads", "iterations", "real_time", "cpu_time", "time_unit", "aggregate_name", "aggregate_unit", "label",
    "error_occurred", "error_message",
}


def rows_of(report):
    """Rows of one report, and the names of benches that gave up."""
    runs = report["benchmarks"]
    broken = [f"{run['name']}: {run.get('error_message', 'failed')}" for run in runs if run.get("error_occurred")]
    repeated = {run["run_name"] for run in runs if run.get("aggregate_name") == "median"}
    rows = []
    for run in runs:
        kind = run.get("aggregate_name", "")
        if run.get("error_occurred") or kind not in ("", "median") or (not kind and run["run_name"] in repeated):
            continue
        rows.append((run["run_name"], "time", run["real_time"], run["time_unit"]))
        for key in sorted(run.keys() - FIXED):
            metric, _, unit = key.partition(" [")
            rows.append((run["run_name"], metric, run[key], unit.rstrip("]")))
    return [dict(zip(FIELDS, row)) for row in rows], broken


def row_of(line):
    """The row that a line of a program's output stands for, or None."""
    cells = line.rstrip("\n").split("\t")
    try:
        return dict(zip(FIELDS, (cells[0], cells[1], float(cells[2]), cells[3]))) if len(cells) == 4 else None
    except ValueError:
        return None


def measure(program, out):
    """Runs one program, showing what it prints; returns (rows, problems)."""
    out.unlink(missing_ok=True)
    rows = []
    command = [program, f"--benchmark_out={out}", "--benchmark_out_format=json"]
    with subprocess.Popen(command, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True) as run:
        for line in run.stdout:
            row = row_of(line)
            if row:
                rows.append(row)
            else:
                print(line, end="", flush=True)
    if run.returncode != 0:
        return rows, [f"{program.name}: ended with exit code {run.returncode}"]
    if out.exists():
        found, problems = rows_of(json.loads(out.read_text(encoding="utf-8")))
        return rows + found, problems
    return rows, [] if rows else [f"{program.name}: measured nothing"]


def table(rows):
    cells = [FIELDS]
    cells += [(row["name"], row["metric"], f"{row['value']:.4g}", row["unit"]) for row in rows]
    widths = [max(len(cell[i]) for cell in cells) for i in range(3)]
    for name, metric, value, unit in cells:
        print(f"{name:{widths[0]}}  {metric:{widths[1]}}  {value:>{widths[2]}}  {unit}".rstrip())


def main():
    if len(sys.argv) < 2:
        print("usage: tools/bench.py BUILD_DIR [NAME...]", file=sys.stderr)
        return 2
    build = Path(sys.argv[1]).resolve()
    names = sys.argv[2:]
    if not names:
        everything = sorted(path.stem for path in (ROOT / "bench").glob("*.cpp"))
        names = [name for name in everything if (build / "bench" / name).exists()]
        for name in sorted(set(everything) - set(names)):
            print(f"== bench: {name} is left out: this build does not have it (tools/setup.sh bench brings what it needs)")
    if not names:
        print("tools/bench.py: there is nothing in bench/ to run", file=sys.stderr)
        return 1
    rows, broken = [], []
    for name in names:
        print(f"== bench: {name}", flush=True)
        found, problems = measure(build / "bench" / name, build / "bench" / f"{name}.json")
        rows += found
        broken += problems
    target = build.parent / "bench.json"
    target.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print()
    table(rows)
    print(f"{len(rows)} rows written to {target.relative_to(ROOT) if target.is_relative_to(ROOT) else target}")
    for problem in broken:
        print(f"FAIL {problem}")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
