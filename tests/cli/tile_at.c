/* The end of the program in tiles.txt: prints the tiles of the preview, a row a line.
   SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** words) {
  const uint32_t seed = (uint32_t)strtoul(words[count - 1], 0, 10);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) printf("%d%c", tile_at(seed, column, row), column < 7 ? ' ' : '\n');
  return 0;
}
