/* The copies that compilers call for even in freestanding programs, plainly. Compile this file with
   -fno-builtin -fno-tree-loop-distribute-patterns (gcc), or the loops become calls of themselves.
   SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdint.h>

/* Rows of a texture are copied all the time: by words where both ends are aligned alike. */
void *memcpy(void *to, const void *from, size_t count) {
  typedef uint32_t __attribute__((may_alias)) word;
  unsigned char *t = to;
  const unsigned char *f = from;
  if ((((uintptr_t)t ^ (uintptr_t)f) & 3) == 0) {
    for (; count > 0 && ((uintptr_t)t & 3) != 0; --count) *t++ = *f++;
    for (; count >= 4; count -= 4, t += 4, f += 4) *(word *)t = *(const word *)f;
  }
  for (; count > 0; --count) *t++ = *f++;
  return to;
}

void *memmove(void *to, const void *from, size_t count) {
  unsigned char *t = to;
  const unsigned char *f = from;
  if (t <= f) return memcpy(to, from, count);
  for (; count > 0; --count) t[count - 1] = f[count - 1];
  return to;
}

void *memset(void *to, int value, size_t count) {
  unsigned char *t = to;
  for (; count > 0; --count) *t++ = (unsigned char)value;
  return to;
}
