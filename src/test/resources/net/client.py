"""A client of an Enlightenment server in another language, written from docs/notes/distributed-protocol.md alone.

It cannot render: the pixels of its tiles come from a picture that was rendered before, a PFM file of the whole region.

    python3 client.py HOST PORT TOKEN-FILE PICTURE.pfm      ("-" instead of a token file for no token)
"""

import hashlib
import hmac
import json
import os
import select
import socket
import struct
import sys
import time

PROTOCOL = 3
HELLO, CHALLENGE, PROOF, WELCOME, REFUSE, JOB, CONTENT_REQUEST, CONTENT, READY = range(1, 10)
GRANT, CANCEL, SKIP, HEARTBEAT, ALIVE, RESULT, ACKNOWLEDGE, BYE = range(10, 18)


# --- "Frames" -------------------------------------------------------------------------------------------------------

def crc_table():
    table = []
    for n in range(256):
        for _ in range(8):
            n = n >> 1 ^ (0x82F63B78 if n & 1 else 0)
        table.append(n)
    return table


CRC_TABLE = crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = CRC_TABLE[(crc ^ byte) & 255] ^ crc >> 8
    return crc ^ 0xFFFFFFFF


def head(major, n):
    if n < 24:
        return bytes([major << 5 | n])
    for code, size, form in ((24, 1, ">B"), (25, 2, ">H"), (26, 4, ">I"), (27, 8, ">Q")):
        if n < 1 << 8 * size:
            return bytes([major << 5 | code]) + struct.pack(form, n)
    raise ValueError(n)


def encode(value):
    if isinstance(value, bool):
        return b"\xf5" if value else b"\xf4"
    if isinstance(value, int):
        return head(0, value) if value >= 0 else head(1, -1 - value)
    if isinstance(value, bytes):
        return head(2, len(value)) + value
    if isinstance(value, str):
        text = value.encode("utf-8")
        return head(3, len(text)) + text
    return head(4, len(value)) + b"".join(encode(v) for v in value)


def decode(data, at=0):
    major, n = data[at] >> 5, data[at] & 31
    at += 1
    if major == 7:
        return {20: False, 21: True}[n], at
    if n >= 24:
        size = {24: 1, 25: 2, 26: 4, 27: 8}[n]
        n = int.from_bytes(data[at:at + size], "big")
        at += size
    if major == 0:
        return n, at
    if major == 1:
        return -1 - n, at
    if major == 2:
        return data[at:at + n], at + n
    if major == 3:
        return data[at:at + n].decode("utf-8"), at + n
    if major != 4:
        raise ValueError("no such value in this protocol: %d" % major)
    items = []
    for _ in range(n):
        item, at = decode(data, at)
        items.append(item)
    return items, at


class Connection:
    def __init__(self, host, port):
        self.socket = socket.create_connection((host, port))
        self.buffer = b""

    def send(self, *message):
        body = encode(list(message))
        self.socket.sendall(struct.pack(">I", len(body)) + body + struct.pack(">I", crc32c(body)))

    def receive(self, seconds=None):
        """The next message; None if none came in time."""
        while True:
            if len(self.buffer) >= 4:
                length = struct.unpack(">I", self.buffer[:4])[0]
                if len(self.buffer) >= length + 8:
                    body = self.buffer[4:4 + length]
                    crc = struct.unpack(">I", self.buffer[4 + length:8 + length])[0]
                    self.buffer = self.buffer[8 + length:]
                    if crc != crc32c(body):
                        raise IOError("a frame was damaged on its way")
                    return decode(body)[0]
            if seconds is not None and not select.select([self.socket], [], [], seconds)[0]:
                return None
            more = self.socket.recv(1 << 16)
            if not more:
                raise IOError("the server closed the connection")
            self.buffer += more


# --- "Handshake" ----------------------------------------------------------------------------------------------------

def shake_hands(connection, token):
    """The welcome of a server that knows the token."""
    nonce = os.urandom(32)
    connection.send(HELLO, "enlightenment", PROTOCOL, PROTOCOL, BUILD, "python", 1, bytes(32), nonce)
    challenge = connection.receive()
    if challenge[0] != CHALLENGE:
        raise IOError("somebody says: %r" % (challenge,))

    def proof(side):
        return hmac.new(token, bytes([side]) + nonce + challenge[2] + bytes(32), hashlib.sha256).digest()

    connection.send(PROOF, proof(1))
    welcome = connection.receive()
    if welcome[0] != WELCOME or not hmac.compare_digest(welcome[1], proof(2)):
        raise IOError("somebody who does not know the token says: %r" % (welcome,))
    return welcome


# --- "The job" ------------------------------------------------------------------------------------------------------

class Document:
    """The job's document, as far as a client needs it that does not read the scene."""

    def __init__(self, data):
        self.data, self.at = data, 0
        if self.short_text() != "enlightenment job 4":
            raise IOError("another job document")
        self.build = self.short_text()
        self.method = self.text()
        self.size = self.take(">ii")
        self.take(">?")
        self.region = self.take(">iiii")
        self.take(">i")
        self.seed = self.take(">q")[0]
        self.take(">ddd")
        self.settings = [self.text() for _ in range(self.take(">i")[0])]
        self.take(">i")
        self.plan = self.text()
        self.level, self.samples = self.take(">dd")
        self.text()
        self.light_paths = self.take(">q")[0]
        self.kinds = [self.text() for _ in range(self.take(">i")[0])]
        self.instants = [self.text() for _ in range(self.take(">i")[0])]
        self.scene = data[self.at:].decode("utf-8")
        self.is_linear = json.loads(self.scene)["shading"]["model"] == "physical"

    def take(self, form):
        values = struct.unpack_from(form, self.data, self.at)
        self.at += struct.calcsize(form)
        return values

    def bytes(self, length):
        self.at += length
        return self.data[self.at - length:self.at]

    def short_text(self):
        return self.bytes(self.take(">H")[0]).decode("utf-8")

    def text(self):
        return self.bytes(self.take(">i")[0]).decode("utf-8")


def fetch(connection, content):
    data = b""
    while True:
        connection.send(CONTENT_REQUEST, content, len(data))
        kind, of, offset, total, piece = connection.receive()
        if kind != CONTENT or of != content or offset != len(data):
            raise IOError("another content than was asked for")
        data += piece
        if len(data) == total:
            if hashlib.sha256(data).digest() != content:
                raise IOError("a content with another hash")
            return data


# --- "Units of work" -------------------------------------------------------------------------------------------------

def up(a, b):
    """a / b, rounded up."""
    return -(-a // b)


class Grid:
    def __init__(self, region, method, samples):
        self.x, self.y, self.width, self.height = region
        self.side = s = {"cluster": 16, "metropolis": 64}.get(method, 8)
        self.first_column = self.x // s
        across = (self.x + self.width - 1) // s - self.first_column + 1
        blocks_down = (self.y + self.height - 1) // s - self.y // s + 1
        self.first_row = self.y // s * s
        wanted = max(4096, min(262144, int(self.width * self.height * samples / 2097152)))
        pieces = max(wanted // across, 1)
        self.rows = min(up(blocks_down, pieces) * s, 16384 // s)
        self.down = up(blocks_down * s, self.rows)
        self.tiles = across * self.down

    def place(self, tile):
        """First and last column, first and last row; the last ones do not belong to it."""
        left = (self.first_column + tile // self.down) * self.side
        top = self.first_row + tile % self.down * self.rows
        return (max(left, self.x), min(left + self.side, self.x + self.width),
                max(top, self.y), min(top + self.rows, self.y + self.height))


def number_of_passes(document):
    width, height = document.size
    if document.plan == "cluster":
        return 1
    if document.plan == "metropolis":
        return 4 if up(width, 64) * up(height, 64) <= 1024 else 1
    blocks = up(width, 8) * up(height, 8)
    most = min(96 * document.samples / 2097152, 262144 / blocks, document.samples / 32)
    return 1 << int(most).bit_length() - 1 if most >= 4 else 1


class Units:
    """Batches of light paths, then tiles or passes over them."""

    def __init__(self, document):
        self.grid = Grid(document.region, document.plan, document.samples)
        self.passes = number_of_passes(document)
        most = 65536
        while up(document.light_paths, most) > 262144 and most < 1 << 30:
            most *= 2
        self.batches = 4 * up(document.light_paths, 4 * most)
        self.paths = up(document.light_paths, self.batches) if self.batches else 0
        self.count = self.batches + self.grid.tiles * self.passes


class Picture:
    """A PFM file: rows from the bottom, three little-endian floats a pixel."""

    def __init__(self, path):
        with open(path, "rb") as file:
            if file.readline() != b"PF\n":
                raise IOError(path + " is no PFM file")
            self.width, self.height = map(int, file.readline().split())
            if float(file.readline()) >= 0:
                raise IOError(path + ": most significant bytes first")
            self.floats = file.read()

    def pixel(self, x, y):
        return struct.unpack_from("<fff", self.floats, 12 * ((self.height - 1 - y) * self.width + x))


def number(n):
    """7 bits a byte, the lowest first."""
    data = b""
    while n > 127:
        data += bytes([n & 127 | 128])
        n >>= 7
    return data + bytes([n])


def batch(units, unit):
    """All light is in the tiles: of four batches one brings light to two corners, one takes it back, two bring none."""
    light = (1 << 40, -1 << 40, 0, 0)[unit % 4]
    last = units.grid.width * units.grid.height - 1
    steps = ([1, last] if last else [1]) if light else []
    data = [number(units.paths), number(len(steps))]
    for step in steps:
        data.append(number(step))
        data += [number(2 * s if s >= 0 else -2 * s - 1) for s in (light, 0, -3 * light)]
    return b"".join(data)


def pixels(document, units, tile, picture):
    grid = units.grid
    left, right, top, bottom = grid.place(tile)
    data = []
    for y in range(top, bottom):
        for x in range(left, right):
            r, g, b = picture.pixel(x - grid.x, y - grid.y)
            if units.passes > 1:
                data.append(struct.pack(">ddddddi", r, 0, g, 0, b, 0, 1))
                continue
            data.append(struct.pack(">dddffi", r, g, b, 0, 0, 1))
            if document.is_linear:
                data.append(struct.pack(">12f", *4 * (r, g, b)))
    return b"".join(data)


def result(document, units, unit, picture):
    # Survey rays, ten counters, two for each kind of primitive, no lost samples, no differences: nothing was counted.
    header = bytes(8 * (12 + 2 * len(document.kinds)))
    if unit < units.batches:
        return header + batch(units, unit)
    return header + pixels(document, units, (unit - units.batches) // units.passes, picture)


# --- "A client, step by step" ----------------------------------------------------------------------------------------

def work(connection, welcome, document, units, picture, job):
    heartbeat, window = welcome[2] / 1000, welcome[4]
    leases, todo, travelling, made, beaten = {}, [], set(), 0, 0
    while True:
        if time.monotonic() - beaten >= heartbeat:
            beaten = time.monotonic()
            connection.send(HEARTBEAT, sorted(leases)[:64])
        while todo and len(travelling) < window:
            lease, tile = todo.pop(0)
            if lease in leases and tile not in travelling:
                connection.send(RESULT, lease, job, tile, result(document, units, tile, picture))
                travelling.add(tile)
        message = connection.receive(heartbeat / 4)
        if message is None:
            continue
        kind = message[0]
        if kind == GRANT and message[2] == job:
            leases[message[1]] = set(range(message[3], message[4]))
            todo += [(message[1], tile) for tile in range(message[3], message[4])]
        elif kind == CANCEL:
            leases.pop(message[1], None)
        elif kind == SKIP:
            todo = [t for t in todo if t[0] != message[1] or not message[2] <= t[1] < message[3]]
            leases.get(message[1], set()).difference_update(set(range(message[2], message[3])) - travelling)
        elif kind == ACKNOWLEDGE:
            travelling.discard(message[1])
            made += 1
            for tiles in leases.values():
                tiles.discard(message[1])
        elif kind in (BYE, REFUSE):
            return made, message[1], kind == BYE
        leases = {lease: tiles for lease, tiles in leases.items() if tiles}


def main(host, port, token_file, picture_file):
    token = b"enlightenment without token"
    if token_file != "-":
        with open(token_file, "rb") as file:
            token = file.read().strip()
    connection = Connection(host, int(port))
    welcome = shake_hands(connection, token)
    message = connection.receive()
    if message[0] != JOB:
        raise IOError("the server says: %r" % (message,))
    _, job, tiles, contents = message
    document = Document(fetch(connection, job))
    units = Units(document)
    if units.count != tiles:
        raise IOError("%d units here, %d there" % (units.count, tiles))
    # Drawn anew, as this process is; a machine that works for longer keeps its secret.
    machine = hmac.new(os.urandom(32), job, hashlib.sha256).digest()
    connection.send(READY, job, os.urandom(32), machine)
    made, reason, done = work(connection, welcome, document, units, Picture(picture_file), job)
    print("%d tiles made: %s" % (made, reason))
    return 0 if done else 1


if __name__ == "__main__":
    BUILD = os.environ.get("ENLIGHTENMENT_BUILD", "0.1.0")
    sys.exit(main(*sys.argv[1:5]))
