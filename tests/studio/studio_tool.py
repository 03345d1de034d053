"""Runs `lissom studio` in a folder of its own, and talks to it as a browser does, or as none would. Standard library only."""
import base64
import contextlib
import http.client
import json
import os
import pathlib
import signal
import socket
import struct
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = os.environ.get("LISSOM_CLI", str(ROOT / "build" / "release" / "lissom"))
CONTINUATION, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10


class Page:
    """A WebSocket of the studio. Text messages are parsed, packs are bytes."""

    def __init__(self, studio, headers=None, cookie=None, receive_buffer=0):
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.socket.settimeout(20)
        self.socket.connect(("127.0.0.1", studio.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.arrived = b""
        self.last_id = 0
        self.events = []
        wanted = {"Host": studio.host, "Origin": f"http://{studio.host}", "Cookie": cookie or studio.cookie, "Connection": "Upgrade",
                  "Upgrade": "websocket", "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": base64.b64encode(b"0123456789abcdef").decode()}
        wanted.update(headers or {})
        lines = [f"{name}: {value}\r\n" for name, value in wanted.items() if value is not None]
        self.socket.sendall(("GET /live HTTP/1.1\r\n" + "".join(lines) + "\r\n").encode())
        while b"\r\n\r\n" not in self.arrived:
            self.receive()
        head, self.arrived = self.arrived.split(b"\r\n\r\n", 1)
        self.status = int(head.split()[1])

    def receive(self):
        piece = self.socket.recv(1 << 20)
        if not piece:
            raise ConnectionError("the studio ended the connection")
        self.arrived += piece

    def send_frame(self, payload, opcode=TEXT, last=True, claimed=None):
        length = len(payload) if claimed is None else claimed
        head = bytes([(0x80 if last else 0) | opcode])
        head += bytes([0x80 | length]) if length < 126 else struct.pack(">BH", 0xFE, length) if length < 65536 else struct.pack(">BQ", 0xFF, length)
        self.socket.sendall(head + b"\0\0\0\0" + payload)

    def receive_frame(self):
        def need(count):
            while len(self.arrived) < count:
                self.receive()
        need(2)
        opcode, length, start = self.arrived[0] & 15, self.arrived[1] & 127, 2
        if length > 125:
            start = 4 if length == 126 else 10
            need(start)
            length = int.from_bytes(self.arrived[2:start], "big")
        need(start + length)
        payload, self.arrived = self.arrived[start:start + length], self.arrived[start + length:]
        return opcode, payload

    def next(self):
        """The next message: an object, or the bytes of a pack. Pings are answered."""
        while True:
            opcode, payload = self.receive_frame()
            if opcode == TEXT:
                return json.loads(payload)
            if opcode == BINARY:
                return payload
            if opcode == PING:
                self.send_frame(payload, PONG)
            if opcode == CLOSE:
                code = int.from_bytes(payload[:2], "big")
                raise ConnectionError(f"closed with code {code}: {payload[2:].decode()}")

    def ask(self, do, **more):
        """The answer to a request; what else arrives before it is kept in `events`."""
        self.last_id += 1
        self.send_frame(json.dumps({"id": self.last_id, "do": do, **more}).encode())
        while True:
            message = self.next()
            if isinstance(message, dict) and message.get("id") == self.last_id:
                return message
            self.events.append(message)

    def hello(self):
        return self.ask("hello", protocol=1)

    def close_code(self):
        """The code with which the studio ends the connection."""
        try:
            while True:
                self.next()
        except ConnectionError as end:
            return str(end)

    def close(self):
        self.socket.close()


class Studio:
    """A running `lissom studio`, let in as one browser."""

    def __init__(self, folder, *arguments, port=0):
        # Results of other tests of this user must not be seen, nor changed.
        places = {"XDG_RUNTIME_DIR": str(folder / ".run"), "XDG_STATE_HOME": str(folder / ".state")}
        for place in places.values():
            pathlib.Path(place).mkdir(exist_ok=True)
        self.errors = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([TOOL, "studio", "--no-browser", "--port", str(port), *arguments], cwd=folder, text=True,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self.errors, env={**os.environ, **places})
        line = self.process.stdout.readline()
        if not line.startswith("Studio: http://127.0.0.1:"):
            self.process.kill()
            raise AssertionError(f"no address: {line!r}\n{self.log()}")
        self.address = line.split(" ", 1)[1].strip()
        self.host = self.address.split("/")[2]
        self.port = int(self.host.split(":")[1])
        self.target = self.address.split(self.host)[1]
        self.cookie = ""

    def let_in(self):
        status, headers, _ = self.get(self.target)
        assert status == 303, status
        self.cookie = headers["Set-Cookie"].split(";")[0]
        return self

    def get(self, target, method="GET", **headers):
        """(status, headers, body) of one request; header names have _ for -, and None leaves one out."""
        wanted = {"Host": self.host, "Cookie": self.cookie or None}
        wanted.update({name.replace("_", "-"): value for name, value in headers.items()})
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        with contextlib.closing(connection):
            connection.putrequest(method, target, skip_host=True, skip_accept_encoding=True)
            for name, value in wanted.items():
                if value is not None:
                    connection.putheader(name, value)
            connection.endheaders()
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()

    def log(self):
        self.errors.seek(0)
        return self.errors.read()

    def logs(self, words):
        deadline = time.monotonic() + 5
        while words not in self.log() and time.monotonic() < deadline:
            time.sleep(0.02)
        return words in self.log()

    def end(self, number=signal.SIGINT):
        """Asks it to end; returns its exit code and the seconds that it took."""
        start = time.monotonic()
        self.process.send_signal(number)
        return self.process.wait(20), time.monotonic() - start

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()
        self.errors.close()
