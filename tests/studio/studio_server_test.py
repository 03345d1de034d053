"""`lissom studio` as it is built: its page, who gets in, what hostile clients get, how it ends and comes back."""
import http.client
import os
import pty
import random
import re
import signal
import socket
import subprocess
import sys
import time
import unittest

from studio_tool import BINARY, ROOT, TEXT, TOOL, Page, Studio

sys.path.insert(0, str(ROOT / "tests" / "apps"))
import tool  # noqa: E402


class StudioTest(tool.ToolTest):
    def studio(self, *arguments, port=0):
        """With a small design, where it does not matter which."""
        arguments = arguments or ("disc-crossed",)
        studio = Studio(self.folder, *arguments, port=port)
        self.addCleanup(studio.close)
        return studio

    def page(self, studio, **more):
        page = Page(studio, **more)
        self.addCleanup(page.close)
        return page

    def assert_serves(self, studio, page=None):
        """It still answers to a page that is there, to a new one, and over HTTP."""
        if page:
            self.assertEqual(page.ask("probe", x=7)["x"], 7)
        new = Page(studio)
        self.assertTrue(new.hello()["ok"])
        new.close()
        self.assertEqual(studio.get("/")[0], 200)


class PageOfTheStudio(StudioTest):
    def test_every_file_of_the_page_arrives_and_fits_the_budget(self):
        studio = self.studio().let_in()
        status, headers, html = studio.get("/")
        self.assertEqual((status, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
        files = set(re.findall(r'(?:src|href)="\.?(/[^"]+)"', html.decode()))
        self.assertTrue(any(name.endswith(".js") for name in files), html)
        total = 0
        for name in {"/"} | files:
            plain = studio.get(name)
            packed = studio.get(name, Accept_Encoding="gzip, deflate, br")
            self.assertEqual((plain[0], packed[0], packed[1]["Content-Encoding"]), (200, 200, "gzip"), name)
            self.assertLess(len(packed[2]), len(plain[2]) + 64)
            self.assertEqual(studio.get(name, If_None_Match=plain[1]["ETag"])[0], 304)
            total += len(packed[2])
        self.assertLessEqual(total, 250_000)

    def test_policy_is_strict_and_the_page_keeps_to_it(self):
        studio = self.studio().let_in()
        _, headers, html = studio.get("/")
        policy = headers["Content-Security-Policy"]
        self.assertTrue(policy.startswith("default-src 'self'; "))
        self.assertNotIn("unsafe", policy)
        self.assertNotIn("*", policy)
        self.assertNotRegex(html.decode(), r"<style|\sstyle=|\son[a-z]+=|<script(?![^>]*\ssrc=)")
        self.assertEqual(headers["Referrer-Policy"], "no-referrer")
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")


class Strangers(StudioTest):
    def test_tokens_cookies_hosts_and_origins(self):
        studio = self.studio()
        self.assertEqual(studio.get("/")[0], 403)
        self.assertEqual(studio.get("/?token=" + 32 * "0")[0], 403)
        studio.let_in()
        self.assertEqual(studio.get(studio.target, Cookie=None)[0], 403, "a token opens once")
        self.assertEqual(studio.get("/", Cookie=studio.cookie[:-1] + "x")[0], 403)
        self.assertEqual(studio.get("/", Host="evil.com")[0], 421)
        self.assertEqual(studio.get("/", Host=f"evil.com:{studio.port}")[0], 421)
        self.assertEqual(studio.get("/", Origin="http://evil.com")[0], 403)
        for bad in ({"Cookie": None}, {"Cookie": "lissom=1"}, {"Origin": "http://evil.com"}, {"Origin": None}, {"Origin": "null"}):
            self.assertEqual(self.page(studio, headers=bad).status, 403, bad)
        self.assertEqual(self.page(studio, headers={"Host": "evil.com"}).status, 421)
        for words in ("another host", "page from elsewhere", "wrong or used token", "without token and cookie"):
            self.assertTrue(studio.logs("lissom studio: refused: a request"), studio.log())
            self.assertTrue(studio.logs(words), studio.log())
        self.assert_serves(studio)

    def test_paths_lead_nowhere(self):
        studio = self.studio().let_in()
        for path in ("/../../../../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/etc/passwd",
                     "/assets/", "/assets/../../../etc/passwd", "/.git/config", "/index.html%00.js", "/\\..\\..\\etc\\passwd",
                     "file:///etc/passwd"):
            status, _, body = studio.get(path)
            self.assertEqual(status, 404, path)
            self.assertNotIn(b"root:", body)
        self.assert_serves(studio)

    def test_files_outside_of_the_folder_are_refused(self):
        (self.folder / "inside").mkdir()
        secret = self.folder / "secret.lissom"
        secret.write_text("{}")
        for name in ("link.lissom", "link.svg", "link.png"):
            (self.folder / "inside" / name).symlink_to(secret)
        (self.folder / "inside" / "out").symlink_to(self.folder)
        studio = self.studio("disc-crossed", "--folder", "inside").let_in()
        page = self.page(studio)
        page.hello()
        requests = (("open", ".lissom", {}), ("save", ".lissom", {}), ("export", ".svg", {"format": "svg"}),
                    ("picture", ".png", {"png_base64": "iVBORw0KGgo="}))
        for do, end, more in requests:
            for place in ("../secret", str(secret.with_suffix("")), "x/../../secret", "link", "out/secret", "a\0b", "../" * 9 + "etc/x"):
                answer = page.ask(do, file=place + end, **more)
                self.assertFalse(answer["ok"], (do, place))
                self.assertTrue(answer["error"]["message"], (do, place))
            self.assertFalse(page.ask(do, file="..", **more)["ok"], do)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), [".run", ".state", "inside", "secret.lissom"])
        self.assertEqual(secret.read_text(), "{}")
        self.assert_serves(studio, page)

    def test_a_hundred_megabytes_are_refused_without_being_taken(self):
        studio = self.studio().let_in()
        page, other = self.page(studio), self.page(studio)
        page.hello()
        other.hello()
        before = self.memory(studio)
        page.send_frame(b"x" * 1000, claimed=100_000_000)
        self.assertIn("1009", page.close_code())
        pieces = self.page(studio)
        with self.assertRaises(OSError):
            for i in range(100):
                pieces.send_frame(b"x" * 1_000_000, opcode=TEXT if i == 0 else 0, last=False)
            pieces.receive()
            raise ConnectionError(pieces.close_code())
        binary = self.page(studio)
        binary.send_frame(b"x", opcode=BINARY)
        self.assertIn("1003", binary.close_code())
        self.assertLess(self.memory(studio) - before, 60_000_000)
        self.assertTrue(studio.logs("too long or binary"))
        self.assert_serves(studio, other)

    @staticmethod
    def memory(studio):
        with open(f"/proc/{studio.process.pid}/status", encoding="ascii") as status:
            return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmRSS"))

    def test_a_thousand_connections(self):
        studio = self.studio().let_in()
        page = self.page(studio)
        page.hello()
        crowd = []
        for _ in range(1000):
            connection = socket.create_connection(("127.0.0.1", studio.port), timeout=5)
            self.addCleanup(connection.close)
            crowd.append(connection)
            self.assertLess(len(crowd), 1001)
        self.assert_serves(studio, page)
        self.assertTrue(studio.logs("too many connections"))
        self.assertLess(len(studio.log().splitlines()), 20)

    def test_noise(self):
        studio = self.studio().let_in()
        witness = self.page(studio)
        witness.hello()
        chance = random.Random(3)
        for i in range(1000):
            page = Page(studio)
            burst = b"".join(self.odd_frame(chance) for _ in range(chance.randrange(1, 8)))
            page.socket.sendall(burst)
            page.close()
            if i % 400 == 0:
                self.assert_serves(studio, witness)
        self.assert_serves(studio, witness)
        self.assertLess(len(studio.log().splitlines()), 20)

    @staticmethod
    def odd_frame(chance):
        kind = chance.randrange(5)
        if kind == 0:
            return chance.randbytes(chance.randrange(1, 60))
        if kind == 1:  # words that are no requests
            words = chance.choice([b"", b"{", b"[1,2]", b'"a"', b"{}", b'{"id": 1}', b'{"id": -1, "do": 3}', b'{"do": "hello", "id": 1e99}',
                                   b"[" * 100, b'{"id": 1, "do": "edit", "edit": {"name": "move_points", "moves": 7}}'])
            return bytes([0x81, 0x80 | len(words), 0, 0, 0, 0]) + words
        if kind == 2:
            return bytes([chance.randrange(256), 0x80 | chance.randrange(126), 0, 0, 0, 0]) + chance.randbytes(20)
        if kind == 3:
            return b"\x81\xff" + chance.randbytes(8) + bytes(4)
        return b"\x88\x82" + bytes(4) + chance.randbytes(2)

    def test_slow_readers_do_not_hold_up_others(self):
        studio = self.studio("butterfly").let_in()
        slow = [self.page(studio, receive_buffer=4096) for _ in range(4)]
        for page in slow:
            page.send_frame(b'{"id": 1, "do": "hello", "protocol": 1}')
        lively = self.page(studio)
        lively.hello()
        start = time.monotonic()
        for i in range(300):  # each sends a shape to every page
            self.assertTrue(lively.ask("fields", rods="curvature" if i % 2 else "axial strain")["ok"])
        self.assertLess(time.monotonic() - start, 10)
        self.assertGreater(sum(isinstance(event, bytes) for event in lively.events), 100)
        self.assert_serves(studio, lively)
        # They catch up with what is in order, and with the newest shape.
        for page in slow:
            page.last_id = 1
            self.assertEqual(page.ask("probe", x="late")["x"], "late")


class ComingAndGoing(StudioTest):
    def test_ends_when_asked_and_forgets_its_sessions(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            studio = self.studio(port=self.free_port()).let_in()
            page = self.page(studio)
            page.hello()
            self.assertTrue(list((self.folder / ".run").rglob("*.session")))
            code, seconds = studio.end(number)
            self.assertEqual(code, 0, studio.log())
            self.assertLess(seconds, 5)
            self.assertIn("1001", page.close_code())
            self.assertFalse(list((self.folder / ".run").rglob("*.session")))

    @staticmethod
    def free_port():
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            return probe.getsockname()[1]

    def test_pages_find_back_after_a_kill(self):
        port = self.free_port()
        first = self.studio(port=port).let_in()
        self.page(first).hello()
        first.process.kill()
        first.process.wait()
        second = self.studio(port=port)
        second.cookie = first.cookie
        self.assert_serves(second)
        self.assertEqual(second.end()[0], 0)
        third = self.studio(port=port)
        third.cookie = first.cookie
        self.assertEqual(third.get("/")[0], 403)

    def test_says_what_is_wrong_with_its_arguments(self):
        studio = self.studio(port=self.free_port())
        self.assertIn(f"port {studio.port} cannot be had", self.run_tool("studio", "--no-browser", "--port", str(studio.port), code=3)[1])
        self.run_tool("studio", "--port", "70000", code=2)
        self.assertIn("absent", self.run_tool("studio", "absent.lissom", "--no-browser", "--port", "0", code=(3, 4))[1])
        self.assertIn("--folder", self.run_tool("studio", "--folder", "absent", "--no-browser", code=4)[1])
        self.write("broken.lissom", "{")
        self.assertIn("broken.lissom", self.run_tool("studio", "broken.lissom", "--no-browser", "--port", "0", code=(3, 4))[1])

    def test_at_a_terminal_it_opens_a_browser_and_prints_more_addresses(self):
        opener = self.folder / "xdg-open"
        opener.write_text('#!/bin/sh\nprintf %s "$1" >opened.part && mv opened.part opened\n')
        opener.chmod(0o755)
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            places = {"DISPLAY": ":0", "PATH": f"{self.folder}:{os.environ['PATH']}", "XDG_RUNTIME_DIR": str(self.folder),
                      "XDG_STATE_HOME": str(self.folder)}
            os.execve(TOOL, [TOOL, "studio", "--port", "0"], {**os.environ, **places})
        self.addCleanup(os.close, terminal)
        shown = ""
        while "Ctrl-C: end" not in shown:
            shown += os.read(terminal, 4096).decode()
        os.write(terminal, b"\n")
        while len(re.findall(r"Studio: (\S+)\r", shown)) < 2:
            shown += os.read(terminal, 4096).decode()
        deadline = time.monotonic() + 5
        while not (self.folder / "opened").exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        addresses = [*re.findall(r"Studio: (\S+)\r", shown), (self.folder / "opened").read_text()]
        self.assertEqual(len(set(addresses)), 3)
        for address in addresses:
            host, target = address.removeprefix("http://").split("/", 1)
            connection = http.client.HTTPConnection(host, timeout=20)
            connection.request("GET", "/" + target)
            self.assertEqual(connection.getresponse().status, 303, address)
            connection.close()
        os.write(terminal, b"\x03")
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)

    def test_help_has_an_example(self):
        done = subprocess.run([TOOL, "studio", "--help"], capture_output=True, text=True, check=True, timeout=20)
        self.assertIn("lissom studio butterfly.lissom", done.stdout)


if __name__ == "__main__":
    tool.main()
