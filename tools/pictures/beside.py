# Pictures side by side: beside.py OUT.png FILE.ppm ... joins PPM files of one height with a white gap between them.
# FILE.ppm:X,Y,W,H is that part of a file.
# SPDX-License-Identifier: MIT
import struct
import sys
import zlib

GAP = 8  # pixels


def read(what):
    path, _, part = what.partition(":")
    with open(path, "rb") as file:
        kind, width, height, most = (file.readline() + file.readline() + file.readline()).split()
        if kind != b"P6" or most != b"255":
            sys.exit(f"{path}: not a PPM of eight bits")
        width, height = int(width), int(height)
        rows = [file.read(3 * width) for _ in range(height)]
    x, y, w, h = (int(number) for number in part.split(",")) if part else (0, 0, width, height)
    return [row[3 * x : 3 * (x + w)] for row in rows[y : y + h]]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


pictures = [read(path) for path in sys.argv[2:]]
if not pictures or len({len(rows) for rows in pictures}) != 1:
    sys.exit("usage: beside.py OUT.png FILE.ppm ..., of one height")
lines = [(b"\xff" * 3 * GAP).join(rows) for rows in zip(*pictures)]
header = struct.pack(">IIBBBBB", len(lines[0]) // 3, len(lines), 8, 2, 0, 0, 0)
with open(sys.argv[1], "wb") as out:
    out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
              chunk(b"IDAT", zlib.compress(b"".join(b"\0" + line for line in lines), 9)) + chunk(b"IEND", b""))
