// The page in headless Chromium, from beginning to end.
//   node page.mjs PAGE GOLDENS NATIVE PICTURES
// PAGE: the built index.html; GOLDENS: presets.txt; NATIVE: folder of what the command line says of zebra-bits with the seed 1337:
// "chunk", rgba of the window 128,-256 128x128, "tile", rgb565 of the torus 96x64, and "list", every preset; PICTURES: folder of
// the screenshots. NODE_PATH must lead to playwright-core.
// SPDX-License-Identifier: MIT
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { createServer } from "node:http";
import { readFileSync } from "node:fs";

const [, , file, goldens, native, pictures] = process.argv;
const { chromium } = createRequire(process.env.NODE_PATH + "/")("playwright-core");
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM, headless: true,
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"],
});
let failures = 0;
const check = (good, what) => {
  if (good) return;
  ++failures;
  console.log("failed: " + what);
};
const open = async (width, height, { before, from, ...options } = {}) => {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(20000);
  page.on("console", (m) => check(m.type() !== "error", "console: " + m.text()));
  page.on("pageerror", (e) => check(false, "error: " + e.message));
  if (before) await page.addInitScript(before);
  await page.goto(from || pathToFileURL(file).href);
  await page.evaluate(() => window.ready);
  return page;
};
const settled = (page) => page.waitForFunction(() => window.page.ground.settled() && !window.page.stale);
const choose = async (page, name) => { await page.selectOption("#preset", name); await settled(page); };
const screen = (page) => page.evaluate(() => { const c = window.page.canvas; return dapple.hash(window.page.context.getImageData(0, 0, Math.min(300, c.width), Math.min(300, c.height)).data); });

// What is on the screen, cell by cell at zoom 1, against one large window. Number of pixels that differ.
const differing = (page) => page.evaluate(() => {
  const p = window.page, s = p.camera.sight(), width = p.canvas.width, height = p.canvas.height;
  p.trial.parse(p.setup.recipe);
  p.trial.begin({ plane: true, x: s.x, y: s.y, width, height }, p.setup.seed);
  while (p.trial.step(100000));
  const want = p.trial.pixels(p.setup.view), have = p.context.getImageData(0, 0, width, height).data;
  let count = 0;
  for (let i = 0; i < have.length; ++i) count += have[i] !== want[i];
  return count;
});

// How often this page itself, not its worker, was asked to grow.
const counting = () => {
  window.steps = 0;
  window.addEventListener("DOMContentLoaded", () => {
    const step = dapple.Desk.prototype.step;
    dapple.Desk.prototype.step = function (rows) { ++window.steps; return step.call(this, rows); };
  });
};

const page = await open(1280, 800, { before: counting });
await settled(page);
await page.screenshot({ path: pictures + "/page-desktop.png" });
check(await page.evaluate(() => Boolean(window.page.growing.worker)), "no worker grows the chunks");

// Every preset of the command line is there, and every one is read.
const listed = readFileSync(native + "/list", "utf8").trim().split("\n").map((l) => l.split(/\s+/)[0]);
const offered = await page.evaluate(() => window.page.presets.map((p) => [p.name, window.page.trial.parse(p.line)]));
check(offered.map((o) => o[0]).join() === listed.join(), "presets: " + offered.map((o) => o[0]).join());
check(offered.every((o) => o[1] === null), "presets refused: " + JSON.stringify(offered.filter((o) => o[1])));

// The bytes of the library: tiles of goldens, and a chunk grown natively.
const golden = async (page, name) => {
  const words = readFileSync(goldens, "utf8").split("\n").map((l) => l.split(" ")).find((w) => w[0] === name && w[1] === "128x128");
  await page.fill("#width", "128");
  await page.fill("#height", "128");
  await page.check("#torus");
  await choose(page, name);
  const have = await page.evaluate(() => {
    const p = window.page, c = p.ground.picture;
    p.trial.parse(p.setup.recipe);
    p.trial.begin({ plane: false, x: 0, y: 0, width: 128, height: 128 }, p.setup.seed);
    while (p.trial.step(100000));
    return [p.trial.fieldHash(), dapple.hash(c.getContext("2d").getImageData(0, 0, c.width, c.height).data)];
  });
  check(have[0] === words[3], name + ": field " + have[0] + ", golden " + words[3]);
  check(have[1] === words[4], name + ": pixels " + have[1] + ", golden " + words[4]);
};
check(await page.evaluate(() => window.page.kernels) === "simd128", "vectors are not used");
for (const name of ["zebra-bits", "fingerprint", "zebra", "zebra-haunch", "gs-maze"]) await golden(page, name);
check(await page.isDisabled("#plane") && /not for the endless plane/.test(await page.textContent("#why")), "gs-maze: the plane is not refused");
await choose(page, "zebra-bits");
await page.check("#plane");
await choose(page, "gs-maze");
check(await page.isChecked("#torus"), "gs-maze: the plane is shown as chosen");
await choose(page, "zebra-bits");
check(await page.isChecked("#plane"), "zebra-bits after gs-maze: not the plane again");
await page.evaluate(() => { window.page.camera.zoom = 1; window.page.camera.place(192, -192); });
await settled(page);
const same = await page.evaluate((want) => {
  const c = window.page.ground.pictures.get("1,-2");
  return c ? c.getContext("2d").getImageData(0, 0, 128, 128).data.every((b, i) => b === want[i]) : null;
}, [...readFileSync(native + "/chunk")]);
check(same === true, "chunk 1,-2 is not the native one: " + same);

// Dragging: chunks come, without seams, and this thread grows none of them.
for (const [dx, dy] of [[-500, -300], [617, 411], [-3, 700]]) {
  await page.evaluate(() => (window.steps = 0));
  await page.mouse.move(480, 400);
  await page.mouse.down();
  await page.mouse.move(480 + dx / 2, 400 + dy / 2, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  check(await page.evaluate(() => window.steps) === 0, "the page's own thread grew chunks");
  const count = await differing(page);
  check(count === 0, `after a drag by ${dx},${dy}: ${count} bytes differ from one window`);
}

// Keys, wheel, buttons.
const camera = () => page.evaluate(() => { const c = window.page.camera; return [c.x, c.y, c.zoom]; });
await page.focus("#view");
let before = await camera();
for (const key of ["ArrowRight", "ArrowDown", "+"]) await page.keyboard.press(key);
let after = await camera();
check(after[0] > before[0] && after[1] > before[1] && after[2] === 2, "keys: " + before + " then " + after);
await page.keyboard.press("-");
await page.click("#closer");
check((await camera())[2] === 2, "the + button");
await page.click("#farther");
await page.mouse.move(300, 300);
await page.mouse.wheel(0, -100);
check((await camera())[2] === 2, "the wheel");
await settled(page);

// The order of the tab key, as far as the numbers.
await page.focus("#view");
const order = [];
for (let i = 0; i < 14; ++i) { await page.keyboard.press("Tab"); order.push(await page.evaluate(() => document.activeElement.id)); }
check(order.join(" ").startsWith("closer farther preset recipe copy png c seed dice paint plane width height"), "tab order: " + order.join(" "));

// Views, seeds, recipes good and broken.
const seen = new Set();
for (const view of ["0", "1", "2", "3", "4", "5", "6"]) { await page.selectOption("#paint", view); await settled(page); seen.add(await screen(page)); }
check(seen.size === 6, "views: " + seen.size + " differ; opacity of 0,1 is the field");
await page.selectOption("#paint", "0");
await settled(page);
const first = await screen(page);
const broken = [
  ["bits windw=6", /^Column 6: 'windw' is not a key of bits; there is masks, .*angle, angles, .*wavelength, /],
  ["", /^Column 1: the recipe is empty; a recipe begins with threshold, mapped, /],
  ["stripes", /^Column 1: no family is called 'stripes'; a recipe begins with threshold, /],
  ["bits window", /^Column 6: 'window' is not key=value/],
  ["bits window=", /^Column 13: a value is missing/],
  ["bits window=x", /^Column 13: 'x' is not a number; numbers are decimal/],
  ["bits window=99", /^Column 13: '99' is out of range, 4 to 8\./],
  ["bits range=0.5,0.5", /^Column 16: '0.5' is out of range, 0.500001 to 20\./],
  ["bits wavelength=400", /^Column 1: the wavelength is out of range, [0-9.]+ to [0-9.]+\./],
  ["bits react=no", /^Column 12: 'no' is not one of md, da\./],
  ["bits ramp=no", /^Column 11: 'no' is not one of a ramp's name, stops like /],
  ["threshold angles=1,2,3,4,5,6", /^Column 18: '1,2,3,4,5,6' has too many numbers/],
  ["threshold fine=3", /fine=F needs levels=L/],
  ["threshold then refine", /^Column 16: 'then refine' needs a stage of level 1 to 3/],
  ["threshold then", /is not one of carry, refine/],
  ["threshold" + " then carry".repeat(4), /at most 4 stages/],
  ["bits \u00e9\u00e9\u00e9=1 window=6", /^Column 6: '\u00e9\u00e9\u00e9' is not a key/],
  ["bits " + "x".repeat(5000), /at most 3999 characters/],
];
for (const [line, words] of broken) {
  await page.fill("#recipe", line);
  const said = await page.textContent("#trouble-recipe");
  check(words.test(said) && await page.getAttribute("#recipe", "aria-invalid") === "true", `broken recipe '${line.slice(0, 40)}': ${said}`);
}
await page.waitForTimeout(300);
await settled(page);
check(await screen(page) === first, "a broken recipe changes the picture");
await page.fill("#recipe", "bits window=6 scale=10 stretch=2 angle=30 ramp=tide");
await page.waitForFunction(() => window.page.setup.recipe.endsWith("tide"));
await settled(page);
check(await screen(page) !== first && await page.textContent("#trouble-recipe") === "" && await page.inputValue("#preset") === "", "a recipe of one's own");
await page.fill("#seed", "x");
check(/seed is a whole number/.test(await page.textContent("#trouble-seed")), "a broken seed");
await page.fill("#seed", "7");
await page.click("#dice");
check(await page.inputValue("#seed") !== "7", "another seed");
await page.check("#torus");
await page.fill("#width", "9");
check(/Tile: .*(multiples|small)/.test(await page.textContent("#trouble-size")), "a broken width: " + await page.textContent("#trouble-size"));
await page.fill("#width", "96");
await page.fill("#height", "64");
await page.waitForFunction(() => window.page.setup.width === 96 && window.page.setup.height === 64);
await settled(page);

// The numbers: a control for each of every family, and each regrows the picture.
const families = await page.evaluate(() => window.page.trial.families);
check(families.length >= 12, "families: " + families.map((f) => f.name));
for (const family of families) {
  await page.selectOption("#n-family", family.name);
  await page.waitForFunction((name) => window.page.setup.recipe === name, family.name);
  for (const n of family.numbers) {
    const control = page.locator("#n-" + n.name);
    check(await control.count() === 1, `${family.name}: no control of ${n.name}`);
    const range = await control.evaluate((c) => [c.type, Number(c.min), Number(c.max)]);
    const one = n.kind === "integer" ? 1 : 1e6;
    if (range[0] === "range") check(range[1] === n.low / one && range[2] === n.high / one, `${family.name}: range of ${n.name} is ${range}`);
    if (n.kind === "word") check(await control.locator("option:not([hidden])").count() === n.words.length, `${family.name}: words of ${n.name}`);
  }
}
const turn = (id, value) => page.locator(id).evaluate((c, v) => { c.value = v; c.dispatchEvent(new Event("input")); }, String(value));
await choose(page, "zebra-bits");
for (const [id, value, line] of [["#n-angle", 30, / angle=30 /], ["#n-rho", 0.1, / rho=0.1( |$)/], ["#n-steps", 5, / steps=5 /], ["#n-light", 4, / light=4( |$)/]]) {
  const was = await screen(page);
  await turn(id, value);
  await page.waitForFunction(() => window.page.setup.recipe === document.getElementById("recipe").value && !window.page.due);
  await settled(page);
  check(line.test(await page.inputValue("#recipe")) && await screen(page) !== was, `${id} does not regrow: ${await page.inputValue("#recipe")}`);
}
await page.selectOption("#n-ramp", "tide");
await page.waitForFunction(() => / ramp=tide /.test(window.page.setup.recipe));
await turn("#n-scale", 64);
await page.waitForFunction(() => document.querySelector("#numbers .trouble").textContent !== "");
check(/^Column \d+: '\S+' is out of range/.test(await page.textContent("#numbers .trouble")), "no words beside the number: " + await page.textContent("#numbers .trouble"));
check(await page.evaluate(() => withValue("bits wavelength=9 angles=1,2 then carry scale=3", "scale", 5)) === "bits angles=1,2 scale=5 then carry scale=3", "a number written into a line");

// Files and the clipboard.
await choose(page, "zebra-bits");
await page.fill("#seed", "1337");
await page.waitForFunction(() => window.page.setup.seed === 1337);
await settled(page);
await page.click("#copy");
await page.waitForFunction(() => document.getElementById("note").textContent !== "");
const line = await page.inputValue("#recipe");
await page.fill("#recipe", "");
await page.focus("#recipe");
await page.keyboard.press("Control+V");
check(await page.inputValue("#recipe") === line, "copied and pasted: " + await page.inputValue("#recipe"));
await page.waitForFunction((l) => window.page.setup.recipe === l, line);
const inFile = (text) => [...text.slice(text.indexOf("= {")).matchAll(/0x([0-9a-f]{2}),/g)].map((m) => parseInt(m[1], 16));
for (const ground of ["#torus", "#plane"]) {
  await page.check(ground);
  await settled(page);
  for (const [id, name] of [["#png", "zebra-bits-1337.png"], ["#c", "zebra-bits-1337.h"]]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(id)]);
    const bytes = readFileSync(await download.path());
    check(download.suggestedFilename() === name, "file name " + download.suggestedFilename());
    if (id === "#c") {
      const pixels = Buffer.from(inFile(bytes.toString()));
      check(pixels.length === 12288 && /uint8_t zebra_bits_1337_pixels\[12288\]/.test(bytes.toString()), "a C array of " + pixels.length);
      if (ground === "#torus") check(pixels.equals(readFileSync(native + "/tile")), "the C array is not the native tile");
      continue;
    }
    const seams = await page.evaluate(async (list) => {  // differing from the library's own pixels
      const picture = await createImageBitmap(new Blob([new Uint8Array(list)])), p = window.page;
      const canvas = canvasOf(picture.width, picture.height), context = canvas.getContext("2d");
      context.drawImage(picture, 0, 0);
      p.trial.parse(p.setup.recipe);
      p.trial.begin(p.domain(p.setup), p.setup.seed);
      while (p.trial.step(100000));
      const want = p.trial.pixels(p.setup.view), have = context.getImageData(0, 0, canvas.width, canvas.height).data;
      return want.length === have.length ? want.reduce((n, b, i) => n + (b !== have[i]), 0) : "size";
    }, [...bytes]);
    check(seams === 0, `${ground} ${name}: ${seams}`);
  }
}

// The tile repeats: at zoom 1 two pixels a tile apart are the same, wherever one looks.
await page.check("#torus");
await page.evaluate(() => { window.page.camera.zoom = 1; window.page.camera.place(1000, -333); });
await settled(page);
check(await page.evaluate(() => {
  const at = (x, y) => window.page.context.getImageData(x, y, 96, 64).data.join();
  return at(50, 70) === at(50 + 96, 70) && at(50, 70) === at(50, 70 + 64) && at(50, 70) !== at(51, 70);
}), "the tile does not repeat");

// A worker that ends: the page goes on by itself, to the same picture.
await page.check("#plane");
await settled(page);
const grown = await screen(page);
await page.evaluate(() => { const { worker } = window.page.growing; worker.onerror(new Event("error", { cancelable: true })); });
await settled(page);
check(await page.evaluate(() => window.page.growing.worker === null) && await screen(page) === grown, "without its worker the page shows something else");
check(await differing(page) === 0, "without its worker: seams");

await page.setViewportSize({ width: 700, height: 500 });
const fits = () => innerWidth === 700 && window.page.canvas.width === window.page.canvas.clientWidth;
check(await page.waitForFunction(fits, null, { timeout: 10000 }).then(() => true, () => false), "resizing");
await settled(page);

// A phone: nothing is wider than the screen, one finger drags, two pinch.
const phone = await open(390, 844, { deviceScaleFactor: 2, hasTouch: true, isMobile: true });
await settled(phone);
check(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "phone: wider than the screen");
await phone.screenshot({ path: pictures + "/page-phone.png" });
const touch = await phone.context().newCDPSession(phone);
const fingers = async (...path) => {
  for (const [i, points] of path.entries())
    await touch.send("Input.dispatchTouchEvent", { type: i === 0 ? "touchStart" : "touchMove", touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  return phone.evaluate(() => { const c = window.page.camera; return [c.x, c.y, c.zoom]; });
};
const still = await fingers([[200, 200]]);
const dragged = await fingers([[200, 200]], [[150, 220]], [[120, 240]]);
check(dragged[0] - still[0] === 40 && dragged[1] - still[1] === -20, `one finger: ${still} then ${dragged}`);
const closer = await fingers([[180, 200], [210, 200]], [[160, 200], [230, 200]], [[120, 200], [270, 200]]);
check(closer[2] > still[2], "a pinch apart: " + closer);
check((await fingers([[100, 200], [290, 200]], [[140, 200], [250, 200]], [[180, 200], [210, 200]]))[2] < closer[2], "a pinch together");
await settled(phone);

// Without a worker: the same bytes, in slices that end when the frame's share is used up.
const alone = await open(500, 400, { before: () => { delete globalThis.Worker; } });
await choose(alone, "zebra-bits");
await alone.evaluate(() => { window.page.camera.zoom = 1; window.page.camera.place(-700, 300); });
await settled(alone);
check(await differing(alone) === 0, "without workers: seams");
const slices = await alone.evaluate(() => {
  const { grower } = window.page.growing, now = performance.now, asked = [];
  const desk = grower.desks.file, step = desk.step;
  desk.step = (rows) => { asked.push(rows); return step.call(desk, rows); };
  grower.take({ kind: "file", order: -1, recipe: "gray-scott", domain: { plane: false, x: 0, y: 0, width: 128, height: 128 }, seed: 1, view: 0, format: 2 });
  let time = 0;
  performance.now = () => (time += 3);  // every slice seems to take 3 ms or more
  grower.rows = 64;
  for (let i = 0; i < 7; ++i) grower.work(time + 7);
  performance.now = now;
  grower.file = null;
  return asked;
});
check(slices.length <= 14 && slices[0] === 64 && slices.slice(0, 7).every((r, i) => r === 64 >> i) && slices.at(-1) === 1, "slices of rows: " + slices);

// The module without vectors, asked for or because there are none; and kernels that are not there.
const address = pathToFileURL(file).href;
const portable = await open(500, 400, { from: address + "?kernels=portable" });
check(await portable.evaluate(() => window.page.kernels) === "portable", "portable kernels are not used");
for (const name of ["zebra-bits", "fingerprint", "zebra", "zebra-haunch"]) await golden(portable, name);
const old = await open(500, 400, { before: () => { WebAssembly.validate = () => false; } });
check(await old.evaluate(() => window.page.kernels) === "portable", "without vectors: " + await old.evaluate(() => window.page.kernels));
await choose(old, "zebra-bits");
await old.evaluate(() => { window.page.camera.zoom = 1; window.page.camera.place(-700, 300); });
await settled(old);
check(await differing(old) === 0, "without vectors: seams");
const none = await open(500, 400, { from: address + "?kernels=neon" });
check(/no kernels are called 'neon'/.test(await none.innerText("#sorry")), "unknown kernels: " + await none.innerText("#sorry"));

// From a server as from a file.
const server = createServer((request, response) => response.writeHead(200, { "Content-Type": "text/html" }).end(readFileSync(file)));
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const served = await open(600, 500, { from: `http://127.0.0.1:${server.address().port}/` });
await settled(served);
check(await served.evaluate(() => Boolean(window.page.growing.worker)), "served: no worker");
server.close();

// Without WebAssembly, with one that refuses the module, without scripts: words instead of nothing.
for (const before of [() => { delete globalThis.WebAssembly; }, () => { WebAssembly.compile = () => Promise.reject(new WebAssembly.CompileError("vectors")); }]) {
  const bare = await open(800, 600, { before });
  check(/needs WebAssembly/.test(await bare.innerText("#sorry")) && await bare.isDisabled("#preset"), "no words where WebAssembly is missing");
}
const mute = await browser.newContext({ javaScriptEnabled: false }).then((c) => c.newPage());
await mute.goto(pathToFileURL(file).href);
check(/needs scripts/.test(await mute.innerText("main")), "no words where scripts are off");
await browser.close();
console.log(failures === 0 ? "the page does what it should" : failures + " failed");
process.exit(failures === 0 ? 0 : 1);
