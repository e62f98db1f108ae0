// How many times as fast as the portable module the one with vectors is, in one interleaved run: least times of many,
// what they grow compared. Prints the table of README.md.
//   node ports/wasm/compare.mjs [MODULES [RUNS]]    MODULES: folder of both (build/wasm); RUNS: of each (15)
// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { grow, scripts, torus } from "../../tests/page/desks.mjs";

const [, , folder = "build/wasm", runs = "15"] = process.argv;
const dapple = scripts(), desks = [];
for (const name of ["dapple", "dapple-simd"]) desks.push((await dapple.load(readFileSync(`${folder}/${name}.wasm`)))());

const line = (name, steps) => {
  const whole = desks[0].presets.find((p) => p.name === name).line;
  return steps ? whole.replace(/ steps=\d+/, " steps=" + steps) : whole;
};
const kinds = [
  ["zebra-bits", line("zebra-bits"), 512],
  ["coral-bits", line("coral-bits"), 512],
  ["fingerprint", line("fingerprint"), 256],
  ["zebra", line("zebra"), 256],
  ["weave", line("weave"), 256],
  ["zebra-haunch, 8 steps", line("zebra-haunch", 8), 256],
  ["gray-scott, 300 steps", "gray-scott steps=300", 256],
  ["a cell program, 400 steps", "cells rule=0xe8e8e8e0 steps=400", 512],
  ["turing, 100 steps", "turing steps=100", 256],
  ["painted: zebra", line("zebra", 2), 512],
  ["painted: sand", line("sand", 2), 512],
];
const pages = 4;  // painted in one go
console.log("| what | portable, ms | vectors | times as fast |\n|---|---|---|---|");
for (const [what, recipe, side] of kinds) {
  const least = [Infinity, Infinity], hashes = [], painted = what.startsWith("painted");
  for (let run = 0; run < Number(runs); ++run)
    for (const [i, desk] of desks.entries()) {
      if (painted && run === 0) grow(desk, recipe, torus(side, side), 7);
      const begun = performance.now();
      if (painted) for (let k = 0; k < pages; ++k) desk.pixels(0);
      else grow(desk, recipe, torus(side, side), 7);
      least[i] = Math.min(least[i], performance.now() - begun);
      if (run === 0) hashes.push(painted ? dapple.hash(desk.pixels(0)) : desk.fieldHash());
    }
  if (hashes[0] !== hashes[1]) throw new Error(what + " differs");
  const ms = least.map((t) => (painted ? t / pages : t).toFixed(2));
  console.log(`| ${what}, ${side}² | ${ms[0]} | ${ms[1]} | ${(least[0] / least[1]).toFixed(1)} |`);
}
