#!/usr/bin/env python3
"""clang-tidy over the sources of the engine, the scenes and the apps; headers are seen through the sources.

    tools/lint.py [FILE...]     default: all .cpp of lissom, scenes and apps

Nine tenths of what clang-tidy does for a source it does for Eigen's headers, so sources are looked at in batches, each
one translation unit that includes them all. Sources whose file-local names meet do not share a batch; a batch that does not
compile all the same is halved until it does.
Compiles without precompiled headers: a source that leans on them does not compile here.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "lint"
BATCH = 16
LOCAL = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# Functions, variables and types at the left margin of a file-local namespace, as clang-format leaves them.
NAME = re.compile(r"^(?!using|return|//|#|\}|template)[A-Za-z].*?\b(\w+)\s*(?:\(|\{|=|;|:(?!:))", re.MULTILINE)
CLASH = re.compile(r": error: .*(redefinition|ambiguous|conflicting|no matching|different kind|redeclar)|clang-diagnostic-error")


def configure():
    """Commands of a configuration without precompiled headers: {absolute source: (flags, directory)}."""
    command = ["cmake", "--preset", "release", "-B", str(BUILD), "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON", "-Wno-dev"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    commands = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        while "CMAKE" in words[0].upper() or "ccache" in words[0] or "=" in words[0] or words[0] in ("-E", "env"):
            words.pop(0)
        cut = words.index("-o")
        commands.setdefault(entry["file"], (tuple(words[1:cut]), entry["directory"]))
    return commands


def local_names(path):
    text = path.read_text(encoding="utf-8")
    return {name for block in LOCAL.findall(text) for name in NAME.findall(block)}


def batches(files, commands):
    """[(flags, directory, [files])]: sources of equal flags whose file-local names do not meet."""
    done, open_ones = [], []
    for path in files:
        flags, directory = commands[str(path)]
        names = local_names(path)
        for batch in open_ones:
            if batch[0] == flags and not batch[3] & names:
                batch[2].append(path)
                batch[3].update(names)
                break
        else:
            batch = (flags, directory, [path], names)
            open_ones.append(batch)
        if len(batch[2]) == BATCH:
            open_ones.remove(batch)
            done.append(batch)
    return [batch[:3] for batch in done + open_ones]


def write_unit(path, files):
    path.write_text("".join(f'#include "{source}"  // NOLINT\n' for source in files))


def compilable(batch, folder):
    """The batch, or its halves and their halves, until all that have several sources compile."""
    flags, directory, files = batch
    if len(files) == 1:
        return [batch]
    folder.mkdir(parents=True, exist_ok=True)
    unit = folder / "batch.cpp"
    write_unit(unit, files)
    quiet = [flag for flag in flags if not flag.startswith(("-W", "-O"))]
    if subprocess.run(["c++", *quiet, "-w", "-fsyntax-only", str(unit)], cwd=directory, capture_output=True).returncode == 0:
        return [batch]
    middle = len(files) // 2
    return [part for half in (files[:middle], files[middle:]) for part in compilable((flags, directory, half), folder)]


def tidy(program, folder, source):
    # A batch has file-local names that a single source does not; g++ looks for shadows anyway.
    extra = ["--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wno-shadow"]
    command = [program, "-p", str(folder), "--quiet", *extra, str(source)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    noise = re.compile(r"^\d+ warnings?.* generated|^Suppressed |^Use -header-filter|^Error while processing")
    text = "\n".join(line for line in (run.stdout + run.stderr).splitlines() if not noise.match(line))
    return run.returncode, text.strip()


def lint(program, index, batch):
    """What clang-tidy says of one batch: (errors?, text, whether its sources had to be looked at singly)."""
    flags, directory, files = batch
    folder = BUILD / f"batch{index}"
    folder.mkdir(parents=True, exist_ok=True)
    unit = folder / "batch.cpp"
    write_unit(unit, files)
    sources = [(unit, flags)] + [(path, flags) for path in files]
    entries = [{"directory": directory, "file": str(path), "arguments": ["c++", *flags, "-c", str(path)]} for path, flags in sources]
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    if len(files) > 1:
        status, text = tidy(program, folder, unit)
        # A crash, too, says nothing of the other files of its batch.
        if status in (0, 1) and not CLASH.search(text):
            return status, text, False
    results = [tidy(program, folder, path) for path in files]
    return any(status for status, _ in results), "\n".join(text for _, text in results if text), len(files) > 1


def main():
    program = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
    if not program:
        sys.exit("tools/lint.py: clang-tidy is missing; run tools/setup.sh ci")
    start = time.monotonic()
    commands = configure()
    named = [Path(name).resolve() for name in sys.argv[1:]]
    files = named or sorted(path for folder in ("lissom", "scenes", "apps") for path in (ROOT / folder).rglob("*.cpp"))
    unknown = [str(path) for path in files if str(path) not in commands]
    if unknown:
        sys.exit("tools/lint.py: not part of the build: " + " ".join(unknown))
    failed, singly = False, 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        tried = pool.map(lambda item: compilable(item[1], BUILD / f"try{item[0]}"), enumerate(batches(files, commands)))
        parts = [part for batch in tried for part in batch]
        for status, text, alone in pool.map(lambda part: lint(program, *part), enumerate(parts)):
            failed, singly = failed or bool(status), singly + alone
            if text:
                print(text, flush=True)
    print(f"== lint: {len(files)} files in {len(parts)} batches, {singly} of them singly, {time.monotonic() - start:.0f} s")
    sys.exit(1 if failed else 0)


main()
