// The controls: what they say becomes a setup; a setup that is refused is told in words and what is there stays.
// SPDX-License-Identifier: MIT
"use strict";

const by = (id) => document.getElementById(id);
const kFirst = "swirl-weave";
const kSlice = 7;  // milliseconds of growing a frame

class Page {
  constructor(makeDesk) {
    this.trial = makeDesk();  // where recipes are tried before anything is given up for them
    this.aside = makeDesk();  // where files grow
    this.grounds = { plane: new Plane(makeDesk()), torus: new Tile(makeDesk()) };
    this.presets = this.trial.presets();
    this.ground = null;
    this.canvas = by("view");
    this.context = this.canvas.getContext("2d", { alpha: false });
    this.camera = new Camera(this.canvas, () => (this.stale = true));
    this.listPresets();
    this.listen();
    this.resize();
    this.choose(kFirst);
    requestAnimationFrame(() => this.frame());
  }

  listPresets() {
    for (const { name, sentence } of this.presets) {
      const option = new Option(name, name);
      option.title = sentence;
      by("preset").add(option);
    }
    by("preset").add(new Option("your own", ""));
  }

  listen() {
    const on = (id, name, does) => by(id).addEventListener(name, does);
    on("preset", "change", () => by("preset").value && this.choose(by("preset").value));
    on("recipe", "input", () => this.later());
    for (const id of ["seed", "width", "height"]) on(id, "input", () => this.later());
    for (const id of ["plane", "torus"]) on(id, "change", () => this.apply());
    on("dice", "click", () => {
      by("seed").value = crypto.getRandomValues(new Uint32Array(1))[0];
      this.apply();
    });
    on("paint", "change", () => this.repaint());
    on("closer", "click", () => this.camera.zoomBy(1));
    on("farther", "click", () => this.camera.zoomBy(-1));
    on("copy", "click", async () => this.note((await copyText(by("recipe"))) ? "The recipe is in the clipboard." : "This browser does not let pages copy; the recipe is marked."));
    on("png", "click", () => this.download("png"));
    on("c", "click", () => this.download("c"));
    on("panel", "submit", (e) => e.preventDefault());
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    window.addEventListener("resize", () => this.resize());
  }

  resize() {
    const scale = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.canvas.clientWidth * scale)), height = Math.max(1, Math.round(this.canvas.clientHeight * scale));
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
    this.stale = true;
    if (this.ground) this.draw();
  }

  note(words) { by("note").textContent = words; }

  choose(name) {
    by("recipe").value = this.presets.find((p) => p.name === name).line;
    this.apply();
  }

  // While one types: the words at once, the growing when the typing stops.
  later() {
    clearTimeout(this.waiting);
    if (this.read()) this.waiting = setTimeout(() => this.apply(), 200);
  }

  // What the controls say; null, and words beside them, if it cannot be.
  read() {
    const line = by("recipe").value.trim();
    const known = this.presets.find((p) => p.line === line);
    by("preset").value = known ? known.name : "";
    by("sentence").textContent = known ? known.sentence : "";
    const marks = { recipe: false, seed: false, width: false, height: false };
    let words = "";
    const refuse = (id, why) => {
      if (!words) words = why;
      marks[id] = true;
    };
    const trouble = this.trial.parse(line);
    if (trouble) refuse("recipe", `Column ${trouble.column}: ${trouble.words}.`);
    const whole = (id, low, high) => {
      const text = by(id).value.trim(), value = /^(0x[0-9a-f]{1,8}|\d{1,10})$/i.test(text) ? Number(text) : NaN;
      if (value >= low && value <= high) return value;
      refuse(id, `The ${id} is a whole number from ${low} to ${high}.`);
      return low;
    };
    const setup = { recipe: line, seed: whole("seed", 0, 4294967295), width: whole("width", 8, 2048), height: whole("height", 8, 2048), view: Number(by("paint").value) };
    if (!words) this.readGround(setup, refuse);
    for (const id in marks) by(id).classList.toggle("wrong", marks[id]);
    by("trouble").textContent = words;
    return words ? null : setup;
  }

  // Recipes that run too long for the plane are shown as a tile.
  readGround(setup, refuse) {
    const small = this.trial.refusal({ plane: true, x: 0, y: 0, width: 64, height: 64 });
    by("plane").disabled = small !== null;
    setup.ground = by("torus").checked || small ? "torus" : "plane";
    const halo = this.trial.halo(), slow = setup.ground === "plane" && halo > 300;
    by("why").textContent = small ? `This recipe is ${small}.` : slow ? `Every chunk is grown with ${halo} cells more on every side: that takes its time. A tile is faster.` : "";
    const refused = setup.ground === "torus" && this.trial.refusal({ plane: false, x: 0, y: 0, width: setup.width, height: setup.height });
    if (refused) refuse("width", "Tile: " + refused + ".");
  }

  apply() {
    clearTimeout(this.waiting);
    const setup = this.read();
    if (!setup) return;
    const ground = this.grounds[setup.ground];
    const words = ground.begin(setup, this.camera);
    if (words) {
      by("trouble").textContent = words + ".";
      return;
    }
    this.ground = ground;
    this.setup = setup;
    this.stale = true;
    this.note("");
  }

  repaint() {
    if (!this.ground) return;
    this.setup.view = Number(by("paint").value);
    this.ground.repaint(this.setup.view, this.camera);
    this.stale = true;
  }

  frame() {
    if (this.ground) {
      if (this.ground.work(this.camera, performance.now() + kSlice)) this.stale = true;
      if (this.stale) this.draw();
    }
    requestAnimationFrame(() => this.frame());
  }

  draw() {
    this.stale = false;
    this.context.fillStyle = "#12110f";
    this.context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.ground.draw(this.context, this.camera);
    const { x, y, zoom } = this.camera, words = this.ground.words();
    by("status").textContent = `${Math.round(x)}, ${Math.round(y)} \u00b7 \u00d7${zoom}` + (words ? " \u00b7 " + words : "");
  }

  // The tile; or of the plane, what lies in the middle of the view, as large as the tile.
  domain(setup) {
    if (setup.ground === "torus") return { plane: false, x: 0, y: 0, width: setup.width, height: setup.height };
    const x = Math.round(this.camera.x - setup.width / 2), y = Math.round(this.camera.y - setup.height / 2);
    return { plane: true, x, y, width: setup.width, height: setup.height };
  }

  async download(kind) {
    const setup = this.setup && { ...this.setup }, busy = (is) => ["png", "c"].forEach((id) => (by(id).disabled = is));
    if (!setup) return;
    const domain = this.domain(setup);
    busy(true);
    const words = await growAside(this.aside, setup.recipe, domain, setup.seed, (share) => this.note(`Growing the file, ${Math.floor(100 * share)} %`));
    busy(false);
    if (words) return this.note(words + ".");
    const known = this.presets.find((p) => p.line === setup.recipe), name = (known ? known.name : "texture") + "-" + setup.seed;
    const place = domain.plane ? ` at ${domain.x},${domain.y}` : "";
    if (kind === "png") {
      const canvas = canvasOf(domain.width, domain.height, this.aside.pixels(setup.view));
      save(name + ".png", await new Promise((made) => canvas.toBlob(made)));
    } else {
      const text = cHeader(name, domain.width, domain.height, this.aside.pixels(setup.view, dapple.formats.rgb565), `${setup.recipe}, seed ${setup.seed}${place}`);
      save(name + ".h", new Blob([text], { type: "text/plain" }));
    }
    this.note(`Saved: ${domain.width} \u00d7 ${domain.height}${place}.`);
  }
}

// For tests and the console: window.page, and the promise of it.
window.ready = (async () => {
  try {
    if (typeof DAPPLE_MODULE === "undefined") throw new Error("this page comes without its module; ports/wasm/build makes one that has it");
    window.page = new Page(await dapple.load(DAPPLE_MODULE));
  } catch (error) {
    const sorry = by("sorry");
    sorry.hidden = false;
    if (typeof WebAssembly !== "undefined" && typeof DAPPLE_MODULE === "undefined") sorry.textContent = error.message;
    for (const control of by("panel").elements) control.disabled = true;
    by("zoom").hidden = true;
  }
})();
