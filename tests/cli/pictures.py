# Decodes pictures for the tests of the command line.
#   pictures.py same A B            the same size, channels and pixels
#   pictures.py size A W H          has that size, and decodes
#   pictures.py depth A BITS        has so many bits a channel
#   pictures.py tiles A             differs across its edges no more than inside
#   pictures.py tiled A B C R       A is B repeated, C columns and R rows
#   pictures.py pages A W H B       A (raw, l1_pages) has the bits of B (raw, l1_msb)
#   pictures.py swapped A B         raw 16-bit pixels with their bytes swapped
#   pictures.py bits A B            the bits of A (PBM) are the pixels of B (PGM of 0 and 255)
#   pictures.py array A B           the bytes of A (C header) are those of B
# SPDX-License-Identifier: MIT
import re
import struct
import sys
import zlib


def png(data):
    place, packed = 8, b''
    while place < len(data):
        length, = struct.unpack('>I', data[place:place + 4])
        kind, body = data[place + 4:place + 8], data[place + 8:place + 8 + length]
        checksum, = struct.unpack('>I', data[place + 8 + length:place + 12 + length])
        assert checksum == zlib.crc32(kind + body), 'CRC of ' + repr(kind)
        if kind == b'IHDR':
            width, height, depth, colour, pack, filters, lace = struct.unpack('>IIBBBBB', body)
            assert (depth in (8, 16), pack, filters, lace) == (True, 0, 0, 0) and (depth == 8 or colour == 0)
        packed += body if kind == b'IDAT' else b''
        place += 12 + length
    assert kind == b'IEND' and place == len(data)
    channels = {0: 1, 2: 3, 6: 4}[colour]
    pixel = channels * depth // 8
    return width, height, channels, values(unfilter(zlib.decompress(packed), width * pixel, height, pixel), depth)


# Bytes, or big-endian pairs of them.
def values(data, depth):
    return data if depth == 8 else struct.unpack('>%dH' % (len(data) // 2), data)


def unfilter(data, line, height, channels):
    assert len(data) == (line + 1) * height
    above, rows = bytearray(line), []
    for y in range(height):
        kind, row = data[y * (line + 1)], bytearray(data[y * (line + 1) + 1:(y + 1) * (line + 1)])
        for x in range(line):
            left, corner = (row[x - channels], above[x - channels]) if x >= channels else (0, 0)
            up = above[x]
            to = left + up - corner
            paeth = min((abs(to - left), 0, left), (abs(to - up), 1, up), (abs(to - corner), 2, corner))[2]
            row[x] = (row[x] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append(bytes(row))
        above = row
    return b''.join(rows)


def qoi(data):
    width, height, channels, space = struct.unpack('>IIBB', data[4:14])
    assert data[-8:] == b'\0\0\0\0\0\0\0\1' and space == 0
    seen, colour, place, pixels = [(0, 0, 0, 0)] * 64, (0, 0, 0, 255), 14, []
    while place < len(data) - 8:
        tag, run = data[place], 1
        r, g, b, a = colour
        place += 1
        if tag == 0xfe:
            r, g, b = data[place:place + 3]
            place += 3
        elif tag == 0xff:
            r, g, b, a = data[place:place + 4]
            place += 4
        elif tag < 0x40:
            r, g, b, a = seen[tag]
        elif tag < 0x80:
            r, g, b = r + (tag >> 4 & 3) - 2, g + (tag >> 2 & 3) - 2, b + (tag & 3) - 2
        elif tag < 0xc0:
            green, second = (tag & 63) - 32, data[place]
            r, g, b = r + green + (second >> 4) - 8, g + green, b + green + (second & 15) - 8
            place += 1
        else:
            run = tag - 0xc0 + 1
        colour = (r & 255, g & 255, b & 255, a)
        seen[(colour[0] * 3 + colour[1] * 5 + colour[2] * 7 + a * 11) % 64] = colour
        pixels += [bytes(colour[:channels])] * run
    assert len(pixels) == width * height
    return width, height, channels, b''.join(pixels)


def pnm(data):
    kind, width, height, rest = re.match(rb'P([456])\n(\d+) (\d+)\n((?s:.*))', data).groups()
    width, height = int(width), int(height)
    if kind == b'4':
        line = (width + 7) // 8
        assert len(rest) == line * height
        pixels = bytes(rest[y * line + x // 8] >> (7 - x % 8) & 1 for y in range(height) for x in range(width))
        return width, height, 1, pixels
    depth, pixels = rest.split(b'\n', 1)
    channels = 1 if kind == b'5' else 3
    pixels = values(pixels, {b'255': 8, b'65535': 16}[depth])
    assert len(pixels) == width * height * channels
    return width, height, channels, pixels


def picture(path):
    data = open(path, 'rb').read()
    return png(data) if data[:4] == b'\x89PNG' else qoi(data) if data[:4] == b'qoif' else pnm(data)


def raw(path):
    return open(path, 'rb').read()


def tiled(a, b, columns, rows):
    width, height, channels, pixels = picture(b)
    line = width * channels
    once = [v for y in range(height) for v in pixels[y * line:(y + 1) * line] * columns]
    wide, high, same, got = picture(a)
    return (wide, high, same, list(got)) == (width * columns, height * rows, channels, once * rows)


# The mean difference of neighbours by place, the last of them across the edge: no more than a third above the largest.
def tiles(a):
    width, height, channels, pixels = picture(a)
    line = width * channels
    across = [sum(abs(pixels[y * line + x * channels + c] - pixels[y * line + (x + 1) % width * channels + c])
                  for y in range(height) for c in range(channels)) for x in range(width)]
    down = [sum(abs(pixels[y * line + x] - pixels[(y + 1) % height * line + x]) for x in range(line))
            for y in range(height)]
    return all(steps[-1] <= max(steps[:-1]) * 4 / 3 for steps in (across, down))


def pages(a, width, height, b):
    a, b, line = raw(a), raw(b), (width + 7) // 8
    size = len(a) == width * ((height + 7) // 8) and len(b) == line * height
    return size and all(a[y // 8 * width + x] >> y % 8 & 1 == b[y * line + x // 8] >> (7 - x % 8) & 1
                        for y in range(height) for x in range(width))


def bits(a, b):
    (w, h, _, ones), (width, height, _, grey) = picture(a), picture(b)
    return (w, h) == (width, height) and bytes(255 * one for one in ones) == grey and 0 < sum(ones) < w * h


def array(a, b):
    return bytes(int(x, 16) for x in re.findall('0x[0-9a-f]{2}', open(a).read())) == raw(b)


def main(word, a, *rest):
    if word == 'same':
        return picture(a) == picture(rest[0])
    if word == 'size':
        return picture(a)[:2] == (int(rest[0]), int(rest[1]))
    if word == 'depth':
        return raw(a)[24] == int(rest[0])
    if word == 'tiles':
        return tiles(a)
    if word == 'tiled':
        return tiled(a, rest[0], int(rest[1]), int(rest[2]))
    if word == 'pages':
        return pages(a, int(rest[0]), int(rest[1]), rest[2])
    if word == 'swapped':
        one, other = raw(a), raw(rest[0])
        return one[::2] == other[1::2] and one[1::2] == other[::2]
    return bits(a, rest[0]) if word == 'bits' else array(a, rest[0])


sys.exit(0 if main(*sys.argv[1:]) else 1)
