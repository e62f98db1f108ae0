#!/usr/bin/env python3
"""What tiles.sh asks about pictures: tiles.py laid FOLDER SIDE FLOOR
laid: the tiles are parts of the sheet, and the preview is the floor whose rows of tile numbers the file FLOOR has.
SPDX-License-Identifier: MIT"""
import os, sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from plane import read_ppm, rows_of


def laid(folder, side, floor):
    side = int(side)
    rows = [[int(word) for word in line.split()] for line in open(floor)]
    assert len(rows) == 8 and all(len(row) == 8 for row in rows), "the floor has 8 x 8 tiles"
    tiles = []
    for number in range(16):
        path = "%s/tile-%02d.ppm" % (folder, number)
        assert read_ppm(path)[:2] == (side, side), path
        tiles.append(rows_of(path, 0, 0, side, side))
        assert tiles[-1] == rows_of(folder + "/sheet.ppm", number % 4 * side, number // 4 * side, side, side), path
    assert read_ppm(folder + "/sheet.ppm")[:2] == (4 * side, 4 * side)
    assert read_ppm(folder + "/preview.ppm")[:2] == (8 * side, 8 * side)
    for y, row in enumerate(rows):
        for x, number in enumerate(row):
            assert tiles[number] == rows_of(folder + "/preview.ppm", x * side, y * side, side, side), (x, y, number)


if __name__ == "__main__":
    {"laid": laid}[sys.argv[1]](*sys.argv[2:])
