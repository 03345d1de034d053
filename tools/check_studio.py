#!/usr/bin/env python3
"""Starts a studio, looks at its page as a browser would, says where it was, and ends it.

    tools/check_studio.py LISSOM studio [OPTION...]      for `make run` where nobody looks

Needs Python's standard library only.
"""

import http.cookiejar
import re
import signal
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request

PATIENCE = 60  # s


def look(address):
    """The number of files of the page and their bytes, as they travel."""
    jar = http.cookiejar.CookieJar()
    browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(jar), urllib.request.ProxyHandler({}))
    browser.addheaders = [("Accept-Encoding", "identity")]
    page = browser.open(address, timeout=PATIENCE).read().decode()
    start = address.split("/?")[0]
    names = re.findall(r'(?:src|href)="\.?/([^"]+)"', page)
    if not names:
        raise ValueError("the page names no files")
    return 1 + len(names), len(page) + sum(len(browser.open(f"{start}/{name}", timeout=PATIENCE).read()) for name in names)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    begun = time.monotonic()
    studio = subprocess.Popen([*sys.argv[1:], "--no-browser"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    watch = threading.Timer(PATIENCE, studio.kill)
    watch.start()
    try:
        line = studio.stdout.readline()
        if not line.startswith("Studio: "):
            sys.exit("tools/check_studio.py: the studio printed no address")
        print(line, end="")
        files, size = look(line.split(" ", 1)[1].strip())
        print(f"  The page answers: {files} files, {size / 1000:.0f} kB, {time.monotonic() - begun:.1f} s after the start. "
              "Nobody looks here, so it ends.")
        studio.send_signal(signal.SIGINT)
        if studio.wait(PATIENCE) != 0:
            sys.exit(f"tools/check_studio.py: the studio ended with exit code {studio.returncode}")
    except (OSError, ValueError, urllib.error.URLError) as error:
        sys.exit(f"tools/check_studio.py: the page does not answer: {error}")
    finally:
        watch.cancel()
        studio.kill()


main()
