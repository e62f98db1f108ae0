// dapple.js in node: the scripts of ports/wasm in a world of their own, as a page has them.
// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import vm from "node:vm";

export const scripts = (changed = {}) => {
  const world = vm.createContext({ WebAssembly, Response, Blob, DecompressionStream, TextEncoder, TextDecoder, atob, ...changed });
  const at = (name) => new URL("../../ports/wasm/" + name, import.meta.url);
  for (const name of ["words.js", "dapple.js"]) vm.runInContext(readFileSync(at(name), "utf8"), world, { filename: name });
  return vm.runInContext("dapple", world);
};

// A texture grown to its end.
export const grow = (desk, line, domain, seed, rows = 100000) => {
  const trouble = desk.parse(line);
  const words = trouble ? trouble.words : desk.begin(domain, seed);
  if (words) throw new Error(`${line}: ${words}`);
  while (desk.step(rows));
};
export const torus = (width, height) => ({ plane: false, x: 0, y: 0, width, height });
