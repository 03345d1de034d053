#!/usr/bin/env python3
"""Every state of the studio's panels in Chromium: no fault of axe, no error in the console, nothing wider than the page.

Runs apps/studio/page/tests/browser/panel_states.mjs against a studio of its own; ends as that does, `N passed, N failed`.
"""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = os.environ.get("LISSOM_CLI", str(ROOT / "build" / "release" / "lissom"))
PATIENCE = 600  # s, on a busy machine without a graphics card


def main():
    with tempfile.TemporaryDirectory() as folder:
        studio = subprocess.Popen([TOOL, "studio", "disc-crossed", "--folder", folder, "--no-browser", "--port", "0"],
                                  stdout=subprocess.PIPE, text=True)
        try:
            address = re.search(r"http://\S+", studio.stdout.readline())
            if not address:
                print("the studio printed no address\n0 passed, 1 failed")
                return 1
            words = ["tools/page.sh", "run", "node", "tests/browser/panel_states.mjs", address[0]]
            return subprocess.run(words, cwd=ROOT, timeout=PATIENCE, check=False).returncode
        finally:
            studio.send_signal(signal.SIGTERM)
            studio.wait(30)


if __name__ == "__main__":
    sys.exit(main())
