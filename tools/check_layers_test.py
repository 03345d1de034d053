#!/usr/bin/env python3
"""Proves that tools/check_layers.py lets a good tree pass and catches every kind of mistake.

Each case writes a small tree with one mistake and expects one finding: at that file and line, of that rule.
Ends with `N passed, N failed`.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

# In parts, so that no search for paths of a machine finds its own test.
WORK = "wo" + "rk"

GOOD = {
    "lissom/core/result.h": "#pragma once\n#include <Eigen/Core>\n#include <vector>\n",
    "lissom/core/linear_solver.h": "#pragma once\n",
    "lissom/core/linear_solver.cpp": '#include "lissom/core/linear_solver.h"\n#include <cholmod.h>\n#include <metis.h>\n',
    "lissom/core/linear_solver_dense.cpp": "",
    "lissom/core/file_io.cpp": "#include <unistd.h>\n",
    "lissom/geometry/frame.h": '#pragma once\n#include "lissom/core/result.h"\n',
    "lissom/model/model.h": '#pragma once\n#include "lissom/geometry/frame.h"\n#include "lissom/core/result.h"\n',
    "lissom/model/model_json.h": "#pragma once\n#include <nlohmann/json_fwd.hpp>\n",
    "lissom/model/model_json.cpp": "#include <nlohmann/json.hpp>\n",
    "lissom/motion/motion.h": "#pragma once\n",
    "lissom/design/design.h": "#pragma once\n",
    "lissom/view/view.h": '#pragma once\n#include "lissom/motion/motion.h"\n',
    "lissom/session/session.cpp": '#include "lissom/view/view.h"\n#include <nlohmann/json.hpp>\n',
    "scenes/scenes.h": '#pragma once\n#include "lissom/model/model.h"\n#include "lissom/motion/motion.h"\n',
    "apps/cli/options.h": "#pragma once\n",
    "apps/cli/main.cpp": '#include <iostream>\n#include "apps/cli/options.h"\n#include "scenes/scenes.h"\n',
    "tests/support.h": "#pragma once\n",
    "tests/unit/a_test.cpp": '#include "tests/support.h"\n#include "scenes/scenes.h"\n#include <nlohmann/json.hpp>\n',
    "tests/unit/b_test.cpp": '#include "bench/matrices.h"\n',
    "apps/studio/server/server.h": "#pragma once\n",
    "tests/studio/a_test.cpp": '#include "apps/studio/server/server.h"\n',
    "bench/matrices.h": "#pragma once\n",
    "bench/a.cpp": '#include "scenes/scenes.h"\n',
    "docs/guide/start.md": "Put it under ../" + WORK + "/ or https://example.org/home/page.\n",
}

MARK = "TO" + "DO"
ROOT_PATH = "/" + "root/x"

# (rule, file, its content, line of the mistake)
BAD = [
    ("layer", "lissom/core/bad.cpp", '#include <vector>\n#include "lissom/geometry/frame.h"\n', 2),
    ("layer", "lissom/motion/bad.cpp", '#include "lissom/design/design.h"\n', 1),
    ("layer", "lissom/design/bad.h", '#pragma once\n\n#include "lissom/motion/motion.h"\n', 3),
    ("layer", "lissom/model/bad.cpp", '#  include   "lissom/view/view.h"\n', 1),
    ("layer", "lissom/session/bad.cpp", '#include "scenes/scenes.h"\n', 1),
    ("layer", "lissom/session/bad.cpp", '#include "apps/cli/options.h"\n', 1),
    ("layer", "apps/cli/bad.cpp", '#include "tests/support.h"\n', 1),
    ("layer", "bench/bad.cpp", '#include "tests/support.h"\n', 1),
    ("layer", "lissom/session/bad.cpp", '#include "bench/matrices.h"\n', 1),
    ("layer", "tests/apps/bad_test.cpp", '#include "apps/cli/options.h"\n', 1),
    ("layer", "tests/unit/bad_test.cpp", '#include "apps/studio/server/server.h"\n', 1),
    ("layer", "tests/studio/bad_test.cpp", '#include "apps/cli/options.h"\n', 1),
    ("layer", "scenes/bad.cpp", '#include "lissom/view/view.h"\n', 1),
    ("folder", "lissom/magic/bad.cpp", "\n", 1),
    ("folder", "lissom/bad.cpp", "\n", 1),
    ("json", "lissom/model/bad.cpp", "#include <nlohmann/json.hpp>\n", 1),
    ("json", "apps/cli/bad.cpp", "#include <nlohmann/json.hpp>\n", 1),
    ("sparse-solver", "lissom/core/eigen_solver.cpp", "#include <suitesparse/cholmod.h>\n", 1),
    ("sparse-solver", "lissom/core/linear_solver_more.h", "#pragma once\n#include <cholmod.h>\n", 2),
    ("sparse-solver", "bench/bad.cpp", "#include <metis.h>\n", 1),
    ("blas-threads", "lissom/equilibrium/bad.cpp", "#include <cblas.h>\n", 1),
    ("iostream", "lissom/view/bad.cpp", "#include <iostream>\n", 1),
    ("iostream", "scenes/bad.cpp", "#include <iostream>\n", 1),
    ("system", "lissom/session/bad.cpp", "#include <sys/mman.h>\n", 1),
    ("public-header", "lissom/core/bad.h", "#pragma once\n#include <fmt/format.h>\n", 2),
    ("rooted", "lissom/core/bad.cpp", '#include "result.h"\n', 1),
    ("rooted", "lissom/geometry/bad.cpp", '#include "lissom/geometry/../core/result.h"\n', 1),
    ("rooted", "lissom/core/bad.cpp", '#include "lissom/core/absent.h"\n', 1),
    ("rooted", "lissom/core/bad.cpp", "#include <lissom/core/result.h>\n", 1),
    ("pragma-once", "lissom/core/bad.h", "int x;\n", 1),
    ("length", "lissom/core/bad.cpp", "\n" * 501, 501),
    ("mark", "tools/bad.py", f"\n# {MARK}: later\n", 2),
    ("machine-path", "docs/guide/bad.md", f"\n\nRun it in {ROOT_PATH}/y.\n", 3),
]


def run(tree):
    """The script's exit code and lines for a tree of files."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in tree.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        script = Path(__file__).parent / "check_layers.py"
        done = subprocess.run([sys.executable, script, folder], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()


def problem_with_bad(rule, file, content, line):
    code, lines = run({**GOOD, file: content})
    findings = lines[:-1]
    if code != 1:
        return f"exit code {code}"
    if len(findings) != 1 or not findings[0].startswith(f"{file}:{line}: {rule}: ") or "; " not in findings[0]:
        return f"expected one finding {file}:{line}: {rule}, got {findings}"
    return None


def main():
    results = []
    code, lines = run(GOOD)
    results.append(("a good tree passes", None if code == 0 and len(lines) == 1 else str(lines)))
    code, lines = run({**GOOD, "lissom/core/long.cpp": "\n" * 301})
    results.append(("a long file warns", None if code == 0 and "warning: length" in lines[0] else str(lines)))
    code, _ = run({"docs/a.md": "nothing here\n"})
    results.append(("an empty tree fails", None if code == 1 else f"exit code {code}"))
    for rule, file, content, line in BAD:
        results.append((f"{rule} in {file}", problem_with_bad(rule, file, content, line)))
    failed = [(name, problem) for name, problem in results if problem]
    for name, problem in failed:
        print(f"FAIL {name}: {problem}")
    print(f"{len(results) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
