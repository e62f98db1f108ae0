// The page in headless Chromium, from beginning to end.
//   node page.mjs PAGE GOLDENS CHUNK PICTURES
// PAGE: the built index.html; GOLDENS: presets.txt; CHUNK: rgba of the window 128,-256 128x128 of zebra-bits with the seed 1337,
// grown natively; PICTURES: folder of the screenshots. NODE_PATH must lead to playwright-core.
// SPDX-License-Identifier: MIT
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { readFileSync } from "node:fs";

const [, , file, goldens, chunk, pictures] = process.argv;
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
const open = async (width, height, options = {}) => {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(20000);
  page.on("console", (m) => check(m.type() !== "error", "console: " + m.text()));
  page.on("pageerror", (e) => check(false, "error: " + e.message));
  await page.goto(pathToFileURL(file).href);
  await page.evaluate(() => window.ready);
  return page;
};
const settled = (page) => page.waitForFunction(() => window.page.ground.settled() && !window.page.stale);
const choose = async (page, name) => { await page.selectOption("#preset", name); await settled(page); };
const screen = (page) => page.evaluate(() => { const c = window.page.canvas; return dapple.hash(window.page.context.getImageData(0, 0, Math.min(300, c.width), Math.min(300, c.height)).data); });

// What is on the screen, cell by cell at zoom 1, against one large window. Number of pixels that differ.
const differing = (page) => page.evaluate(() => {
  const p = window.page, s = p.camera.sight(), width = p.canvas.width, height = p.canvas.height;
  p.aside.parse(p.setup.recipe);
  p.aside.begin({ plane: true, x: s.x, y: s.y, width, height }, p.setup.seed);
  while (p.aside.step(100000));
  const want = p.aside.pixels(p.setup.view), have = p.context.getImageData(0, 0, width, height).data;
  let count = 0;
  for (let i = 0; i < have.length; ++i) count += have[i] !== want[i];
  return count;
});

const page = await open(1280, 800);
await settled(page);
await page.screenshot({ path: pictures + "/page-desktop.png" });

// The bytes of the library: tiles of goldens, and a chunk grown natively.
for (const name of ["zebra-bits", "fingerprint", "zebra", "gs-maze"]) {
  const words = readFileSync(goldens, "utf8").split("\n").map((l) => l.split(" ")).find((w) => w[0] === name && w[1] === "128x128");
  await page.fill("#width", "128");
  await page.fill("#height", "128");
  await page.check("#torus");
  await choose(page, name);
  const have = await page.evaluate(() => {
    const p = window.page, c = p.ground.picture;
    return [p.ground.desk.fieldHash(), dapple.hash(c.getContext("2d").getImageData(0, 0, c.width, c.height).data)];
  });
  check(have[0] === words[3], name + ": field " + have[0] + ", golden " + words[3]);
  check(have[1] === words[4], name + ": pixels " + have[1] + ", golden " + words[4]);
}
check(await page.isDisabled("#plane") && /not for the endless plane/.test(await page.textContent("#why")), "gs-maze: the plane is not refused");
await choose(page, "zebra-bits");
await page.check("#plane");
await page.evaluate(() => { window.page.camera.zoom = 1; window.page.camera.place(192, -192); });
await settled(page);
const native = await page.evaluate((want) => {
  const have = window.page.ground.desk.chunk(1, -2);
  return have ? have.every((b, i) => b === want[i]) && have.length === want.length : null;
}, [...readFileSync(chunk)]);
check(native === true, "chunk 1,-2 is not the native one: " + native);

// Dragging: chunks come, without seams.
for (const [dx, dy] of [[-500, -300], [617, 411], [-3, 700]]) {
  await page.mouse.move(480, 400);
  await page.mouse.down();
  await page.mouse.move(480 + dx / 2, 400 + dy / 2, { steps: 4 });
  await page.mouse.up();
  await settled(page);
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

// The order of the tab key.
await page.focus("#view");
const order = [];
for (let i = 0; i < 14; ++i) { await page.keyboard.press("Tab"); order.push(await page.evaluate(() => document.activeElement.id)); }
check(order.join(" ").startsWith("closer farther preset recipe seed dice plane width height paint copy png c"), "tab order: " + order.join(" "));

// Views, seeds, recipes good and broken.
const seen = new Set();
for (const view of ["0", "1", "2", "3", "4", "5", "6"]) { await page.selectOption("#paint", view); await settled(page); seen.add(await screen(page)); }
check(seen.size === 6, "views: " + seen.size + " differ; opacity of 0,1 is the field");
await page.selectOption("#paint", "0");
await settled(page);
const first = await screen(page);
await page.fill("#recipe", "bits windw=6");
check(/^Column 6: 'windw' is not a key of bits/.test(await page.textContent("#trouble")), "a broken recipe: " + await page.textContent("#trouble"));
await page.waitForTimeout(300);
await settled(page);
check(await screen(page) === first, "a broken recipe changes the picture");
await page.fill("#recipe", "bits window=6 scale=10 stretch=2 angle=30 ramp=tide");
await page.waitForFunction(() => window.page.setup.recipe.endsWith("tide"));
await settled(page);
check(await screen(page) !== first && await page.textContent("#trouble") === "" && await page.inputValue("#preset") === "", "a recipe of one's own");
await page.fill("#seed", "x");
check(/seed is a whole number/.test(await page.textContent("#trouble")), "a broken seed");
await page.fill("#seed", "7");
await page.click("#dice");
check(await page.inputValue("#seed") !== "7", "another seed");
await page.check("#torus");
await page.fill("#width", "9");
check(/Tile: .*(multiples|small)/.test(await page.textContent("#trouble")), "a broken width: " + await page.textContent("#trouble"));
await page.fill("#width", "96");
await page.fill("#height", "64");
await page.waitForFunction(() => window.page.setup.width === 96 && window.page.setup.height === 64);
await settled(page);

// Files and the clipboard.
await page.click("#copy");
await page.waitForFunction(() => document.getElementById("note").textContent !== "");
for (const ground of ["#torus", "#plane"]) {
  await page.check(ground);
  for (const [id, name] of [["#png", ".png"], ["#c", ".h"]]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(id)]);
    const bytes = readFileSync(await download.path());
    check(download.suggestedFilename().endsWith(name), "file name " + download.suggestedFilename());
    check(id === "#png" ? bytes.readUInt32BE(16) === 96 && bytes.readUInt32BE(20) === 64 : /texture_\d+_pixels\[12288\] = \{\n {2}0x/.test(bytes.toString()), "file " + name);
  }
}
await page.setViewportSize({ width: 700, height: 500 });
const fits = () => innerWidth === 700 && window.page.canvas.width === window.page.canvas.clientWidth;
check(await page.waitForFunction(fits, null, { timeout: 10000 }).then(() => true, () => false), "resizing");
await settled(page);

const phone = await open(390, 844, { deviceScaleFactor: 2, hasTouch: true, isMobile: true });
await settled(phone);
check(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "phone: wider than the screen");
await phone.screenshot({ path: pictures + "/page-phone.png" });

// Without WebAssembly: words instead of nothing.
const bare = await browser.newPage();
await bare.addInitScript(() => { delete globalThis.WebAssembly; });
await bare.goto(pathToFileURL(file).href);
await bare.evaluate(() => window.ready);
check(/needs WebAssembly/.test(await bare.innerText("#sorry")), "no words where WebAssembly is missing");
await browser.close();
console.log(failures === 0 ? "the page does what it should" : failures + " failed");
process.exit(failures === 0 ? 0 : 1);
