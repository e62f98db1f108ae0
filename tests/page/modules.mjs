// Both modules in node: what they grow is what tests/golden says, and what one paints the other paints.
//   node modules.mjs MODULES GOLDENS    MODULES: folder of dapple.wasm and dapple-simd.wasm; GOLDENS: tests/golden
// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { grow, scripts, torus } from "./desks.mjs";

const [, , folder, goldens] = process.argv;
let failures = 0, compared = 0;
const check = (good, what) => {
  ++compared;
  if (good) return;
  ++failures;
  console.log("failed: " + what);
};
const lines = (name) => readFileSync(`${goldens}/${name}`, "utf8").trim().split("\n").map((l) => l.split(" "));

// Which one is taken.
const dapple = scripts();
const files = { simd128: readFileSync(folder + "/dapple-simd.wasm"), portable: readFileSync(folder + "/dapple.wasm") };
const taken = (have, modules, asked) => {
  const world = scripts({ WebAssembly: { validate: (code) => have && WebAssembly.validate(code) } });
  try {
    return world.choose(modules, asked);
  } catch (refusal) {
    return refusal.message;
  }
};
check(dapple.vectors(), "this node has no vectors");
check(WebAssembly.validate(files.simd128) && WebAssembly.validate(files.portable), "a module is not valid");
check(taken(true, files) === "simd128" && taken(true, files, "portable") === "portable", "with vectors: " + taken(true, files));
check(taken(false, files) === "portable", "without vectors: " + taken(false, files));
check(/needs vectors/.test(taken(false, files, "simd128")), "simd128 without vectors: " + taken(false, files, "simd128"));
check(/'neon'; there are simd128, portable/.test(taken(true, files, "neon")), "unknown kernels: " + taken(true, files, "neon"));

const desks = {};
for (const name of Object.keys(files)) desks[name] = (await dapple.load(files, name))();

// Those that do not take long.
const steps = (line) => [...line.matchAll(/ steps=(\d+)/g)].reduce((sum, m) => sum + Number(m[1]), 0);
const few = new Set(desks.portable.presets.filter((p) => steps(p.line) <= 100).map((p) => p.name));
check(few.size >= 45, `${few.size} presets are looked at`);

const odd = new Map(lines("presets.txt").filter((l) => few.has(l[0])).map((l) => [l[0], l]));  // each one's last size, not even
for (const [name, desk] of Object.entries(desks)) {
  const line = (preset) => desk.presets.find((p) => p.name === preset).line;
  for (const [preset, size, seed, field, pixels] of odd.values()) {
    const [width, height] = size.split("x").map(Number);
    grow(desk, line(preset), torus(width, height), Number(seed));
    check(desk.fieldHash() === field, `${name} ${preset} ${size}: field ${desk.fieldHash()}, golden ${field}`);
    check(dapple.hash(desk.pixels(0)) === pixels, `${name} ${preset} ${size}: pixels differ`);
  }
}

// Sizes of every remainder, every view and format.
const recipes = ["bits level=0 window=8 masks=3 react=da solver=lean steps=4 light=2", "bits level=0 window=4 scale=5 steps=4 grain=0.3", "cells rule=0x6996e8a1 steps=9",
  "flow level=0 threads=2 field=vector nodes=16 window=5 steps=4 light=1 gloss=0.4", "mapped map=swirl pairs=2 steps=4 light=1",
  "mapped map=scallop solver=lean steps=3", "threshold pairs=2 react=da steps=3 light=3",
  "gray-scott steps=20", "turing steps=9 stretch=2"];
for (const recipe of recipes)
  for (let width = 60; width <= 92; width += 3) {
    const [one, other] = Object.entries(desks).map(([name, desk]) => {
      grow(desk, recipe, torus(width, 60 + width % 5), width, name === "portable" ? 7 : 100000);
      const all = [desk.fieldHash()];
      for (let view = 0; view < 7; ++view)
        for (const format of Object.values(dapple.formats)) all.push(dapple.hash(desk.pixels(view, format)));
      return all;
    });
    check(one.join() === other.join(), `${recipe}, ${width} wide: hash ${one.findIndex((h, i) => h !== other[i])} differs`);
  }
console.log(`${compared} compared, ${failures} failed`);
process.exit(failures === 0 ? 0 : 1);
