// The controls: what they say becomes a setup; a setup that is refused is told in words and what is there stays.
// SPDX-License-Identifier: MIT
"use strict";

const by = (id) => document.getElementById(id);
const kFirst = "swirl-weave";
const kSlice = 7;    // milliseconds of growing a frame, where there is no worker
const kPause = 120;  // milliseconds after which what is typed counts

class Page {
  constructor(makeDesk, module) {
    this.trial = makeDesk();  // where recipes are tried before anything is given up for them
    this.growing = new Growing(module, makeDesk, (answer) => this.hear(answer), () => this.again());
    this.grounds = { plane: new Plane(this.growing), torus: new Tile(this.growing) };
    this.presets = this.trial.presets;
    this.numbers = new Panel(by("numbers"), this.trial, (line) => this.turned(line));
    this.ground = null;
    this.wished = "plane";  // the ground that was last chosen by hand
    this.canvas = by("view");
    this.context = this.canvas.getContext("2d", { alpha: false });
    this.camera = new Camera(this.canvas, () => (this.stale = true));
    by("more").open = window.innerWidth > 700;
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
    for (const id of ["plane", "torus"]) on(id, "change", () => {
      this.wished = id;
      this.apply();
    });
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
    if (this.read()) this.waiting = setTimeout(() => this.apply(), kPause);
  }

  // A control of the numbers wrote a line: it grows with the next frame.
  turned(line) {
    by("recipe").value = line;
    this.due = true;
  }

  hear(answer) {
    if (answer.kind === "file") return void (this.file && this.file(answer));
    if (!this.ground || answer.order !== this.ground.order) return;
    if (answer.words) return this.tell({ recipe: answer.words + "." });
    this.ground.hear(answer);
    this.stale = true;
  }

  // The worker has ended; what it was to do is begun anew on this side.
  again() {
    if (this.file) this.file({ words: "the worker ended; try again" });
    if (this.ground) this.ground.begin(this.setup);
    this.stale = true;
  }

  // Words beside the fields they are about: { recipe, seed, size }.
  tell(words) {
    for (const field of ["recipe", "seed", "size"]) by("trouble-" + field).textContent = words[field] || "";
    for (const [id, field] of [["recipe", "recipe"], ["seed", "seed"], ["width", "size"], ["height", "size"]]) {
      const wrong = Boolean(words[field]) && (!words.only || words.only.includes(id));
      by(id).classList.toggle("wrong", wrong);
      by(id).setAttribute("aria-invalid", String(wrong));
    }
  }

  // What the controls say; null, and words beside them, if it cannot be.
  read() {
    const line = by("recipe").value.trim(), words = {};
    const known = this.presets.find((p) => p.line === line);
    by("preset").value = known ? known.name : "";
    by("sentence").textContent = known ? known.sentence : "";
    const trouble = this.trial.parse(line);
    if (trouble) this.numbers.tell((words.recipe = `Column ${trouble.column}: ${trouble.words}.`));
    else this.numbers.show(line);
    const whole = (id, field, low, high) => {
      const text = by(id).value.trim(), value = /^(0x[0-9a-f]{1,8}|\d{1,10})$/i.test(text) ? Number(text) : NaN;
      if (value >= low && value <= high) return value;
      words[field] = `The ${id} is a whole number from ${low} to ${high}, not '${text.slice(0, 20)}'.`;
      words.only = [...(words.only || ["recipe"]), id];
      return low;
    };
    const seed = whole("seed", "seed", 0, 4294967295), width = whole("width", "size", 8, 2048), height = whole("height", "size", 8, 2048);
    const setup = { recipe: line, seed, width, height, view: Number(by("paint").value) };
    if (!trouble) this.readGround(setup, words);
    this.tell(words);
    return words.recipe || words.seed || words.size ? null : setup;
  }

  // Recipes that run too long for the plane are shown as a tile, and the plane again with the next that does not.
  readGround(setup, words) {
    const refused = this.trial.refusal({ plane: true, x: 0, y: 0, width: 64, height: 64 });
    by("plane").disabled = refused !== null;
    setup.ground = refused ? "torus" : this.wished;
    by(setup.ground).checked = true;
    setup.halo = this.trial.halo();
    const slow = setup.ground === "plane" && setup.halo > 300;
    by("why").textContent = refused ? `This recipe is ${refused}.`
      : slow ? `Every chunk is grown with ${setup.halo} cells more on every side: that takes its time. A tile is faster.` : "";
    const small = setup.ground === "torus" && !words.size &&
      this.trial.refusal({ plane: false, x: 0, y: 0, width: setup.width, height: setup.height });
    if (!small) return;
    words.size = `Tile: ${small}.`;
    if (words.only) words.only.push("width", "height");
  }

  apply() {
    clearTimeout(this.waiting);
    this.due = false;
    const setup = this.read();
    if (!setup) return;
    this.ground = this.grounds[setup.ground];
    this.setup = setup;
    this.ground.begin(setup);
    this.stale = true;
    this.note("");
  }

  repaint() {
    if (!this.ground) return;
    this.setup.view = Number(by("paint").value);
    this.ground.repaint();
    this.stale = true;
  }

  frame() {
    if (this.due) this.apply();
    this.growing.work(performance.now() + kSlice);
    if (this.stale && this.ground) this.draw();
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

  // Pixels of `domain`, or throws words.
  grow(setup, domain, format) {
    return new Promise((made, failed) => {
      const order = ++orders;
      this.file = (answer) => {
        if (answer.words) failed(answer.words);
        else if (answer.pixels) made(new Uint8ClampedArray(answer.pixels));
        else this.note(`Growing the file, ${Math.floor(100 * answer.share)} %`);
      };
      this.growing.order({ kind: "file", order, recipe: setup.recipe, domain, seed: setup.seed, view: setup.view, format });
    });
  }

  async download(kind) {
    const setup = this.setup && { ...this.setup }, busy = (is) => ["png", "c"].forEach((id) => (by(id).disabled = is));
    if (!setup) return;
    const domain = this.domain(setup), { width, height } = domain;
    busy(true);
    try {
      const known = this.presets.find((p) => p.line === setup.recipe), name = (known ? known.name : "texture") + "-" + setup.seed;
      const place = domain.plane ? ` at ${domain.x},${domain.y}` : "";
      const pixels = await this.grow(setup, domain, kind === "png" ? dapple.formats.rgba8888 : dapple.formats.rgb565);
      if (kind === "png") {
        save(name + ".png", await new Promise((made) => canvasOf(width, height, pixels).toBlob(made)));
      } else {
        const text = cHeader(name, width, height, pixels, `${setup.recipe}, seed ${setup.seed}${place}`);
        save(name + ".h", new Blob([text], { type: "text/plain" }));
      }
      this.note(`Saved: ${width} \u00d7 ${height}${place}.`);
    } catch (words) {
      this.note(words + ".");
    }
    this.file = null;
    busy(false);
  }
}

// For tests and the console: window.page, and the promise of it. ?kernels=portable takes the module without vectors.
window.ready = (async () => {
  try {
    if (typeof DAPPLE_MODULES === "undefined")
      throw new dapple.Refusal("this page comes without its modules; ports/wasm/build makes one that has them");
    const kernels = dapple.choose(DAPPLE_MODULES, new URLSearchParams(location.search).get("kernels"));
    window.page = new Page(await dapple.load(DAPPLE_MODULES, kernels), DAPPLE_MODULES[kernels]);
    window.page.kernels = kernels;
  } catch (error) {
    const sorry = by("sorry");
    sorry.hidden = false;
    if (error instanceof dapple.Refusal) sorry.textContent = error.message;
    for (const control of by("panel").elements) control.disabled = true;
    by("zoom").hidden = true;
  }
})();
