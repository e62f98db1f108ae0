// The tile, or a piece of the plane as large, as a file: PNG, or a C array of 16-bit colours.
// SPDX-License-Identifier: MIT
"use strict";

// A C header as `dapple grow --format c` writes it.
function cHeader(name, width, height, bytes, note) {
  const low = name.replace(/[^A-Za-z0-9]/g, "_"), high = low.toUpperCase();
  const lines = [];
  for (let i = 0; i < bytes.length; i += 20)
    lines.push("  " + Array.from(bytes.subarray(i, i + 20), (b) => "0x" + b.toString(16).padStart(2, "0") + ",").join(" "));
  return `/* ${name}: ${width} x ${height} pixels, rgb565, ${2 * width} bytes a row.\n   ${note} */\n` +
    `#ifndef DAPPLE_${high}_H\n#define DAPPLE_${high}_H\n\n#include <stdint.h>\n\n` +
    `#define ${high}_WIDTH ${width}\n#define ${high}_HEIGHT ${height}\n#define ${high}_FORMAT "rgb565"\n\n` +
    `#ifdef __GNUC__\n__attribute__((unused))\n#endif\nstatic const uint8_t ${low}_pixels[${bytes.length}] = {\n` +
    lines.join("\n") + "\n};\n\n#endif\n";
}

function save(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// The clipboard where the browser allows it (not everywhere from a file), else by way of the field itself.
async function copyText(field) {
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch (error) {
    field.select();
    return document.execCommand("copy");
  }
}
