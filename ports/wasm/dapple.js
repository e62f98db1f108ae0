// The WebAssembly modules for scripts, one for engines with vectors and one for all: memory laid out, text both ways. A Desk is
// one instance with one recipe and one texture; beginning anew uses the same memory again. Needs words.js.
// SPDX-License-Identifier: MIT
"use strict";

const dapple = {
  formats: { l8: 0, rgb888: 1, rgba8888: 2, rgb565: 3 },
  pixelBytes: [1, 3, 4, 2],  // by format
  kinds: ["decimal", "integer", "program", "word", "schedule", "angles"],  // of numbers
  enough: -15,  // too_little_memory: what begin says to a question

  // Names of modules, { simd128, portable }: the one asked for, else the fastest that this engine runs.
  choose(modules, asked) {
    const names = Object.keys(modules), runs = (name) => name !== "simd128" || dapple.vectors();
    if (!asked) return names.find(runs);
    if (!names.includes(asked)) throw new dapple.Refusal(`no kernels are called '${asked}'; there are ${names.join(", ")}`);
    if (!runs(asked)) throw new dapple.Refusal(`kernels=${asked} needs vectors of 128 bits, which this engine does not have`);
    return asked;
  },

  // Whether there are vectors: (func (drop (i8x16.splat (i32.const 0)))).
  vectors() {
    const code = [0x41, 0, 0xfd, 0x0f, 0x1a, 0x0b], head = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
    return WebAssembly.validate(Uint8Array.from([...head, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0, 10, 9, 1, 7, 0, ...code]));
  },

  // From modules by name, the fastest first, of which one is taken (`kernels`, or as choose says), or from one module. A module
  // is bytes, base64, either of them packed by gzip, or a function that promises one. A promise of what makes desks.
  async load(modules, kernels) {
    const alone = typeof modules === "string" || ArrayBuffer.isView(modules);
    let module = alone ? modules : modules[dapple.choose(modules, kernels)];
    if (typeof module === "function") module = await module();
    let bytes = typeof module === "string" ? Uint8Array.from(atob(module), (c) => c.charCodeAt(0)) : new Uint8Array(module);
    if (bytes[0] === 0x1f && bytes[1] === 0x8b) bytes = new Uint8Array(await dapple.gunzip(bytes).arrayBuffer());
    const compiled = await WebAssembly.compile(bytes);
    const make = (texts) => new dapple.Desk(new WebAssembly.Instance(compiled, {}).exports, texts);
    const texts = await dapple.unpacked(make({ presets: [], units: [] }).packed());
    return () => make(texts);
  },

  gunzip(bytes) { return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))); },

  // Presets, and the sentences about numbers, out of their gzip stream.
  async unpacked(bytes) {
    const text = await dapple.gunzip(bytes).text();
    const part = text.split("\0"), presets = [];
    while (part[0] !== "") {
      const [name, sentence, line] = part.splice(0, 3);
      presets.push({ name: name.replace(/_/g, "-"), sentence, line });
    }
    return { presets, units: part.slice(1) };
  },

  // FNV-1a, 64 bit, as hexadecimal digits.
  hash(bytes) {
    let hash = 0xcbf29ce484222325n;
    for (const byte of bytes) hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & 0xffffffffffffffffn;
    return hash.toString(16).padStart(16, "0");
  },
};

// What cannot be, in words.
dapple.Refusal = class extends Error {};

dapple.Desk = class {
  constructor(exports, { presets, units }) {
    this.exports = exports;
    this.presets = presets;
    units = [...units];
    const after = (at, bytes) => (at + bytes + 15) & ~15;
    this.recipe = exports.heap();
    this.texture = after(this.recipe, exports.recipe_bytes());
    this.memory = after(this.texture, exports.texture_bytes());
    this.room = exports.text_bytes();
    this.reach(this.memory);
    exports.limits();
    const [stages, halo, side] = this.told(3);
    this.limits = { stages, halo, side };
    this.families = this.list(exports.family).map((name, i) => {
      exports.family(i);
      const [steps] = this.told(1), names = this.list((k) => exports.number(i, k));
      return { name, steps, numbers: names.map((_, k) => ({ ...this.number(i, k), unit: units.shift() })) };
    });
  }

  // Memory so that `end` is still within it.
  reach(end) {
    const missing = end - this.exports.memory.buffer.byteLength;
    if (missing <= 0) return true;
    try {
      this.exports.memory.grow(Math.ceil(missing / 65536));
      return true;
    } catch (error) {
      return false;
    }
  }

  bytes(at, length) { return new Uint8Array(this.exports.memory.buffer, at, length); }
  told(count) { return [...new Int32Array(this.exports.memory.buffer, this.exports.told(), count)]; }

  // Text ended by a zero, or null.
  text(at) {
    if (at === 0) return null;
    const all = new Uint8Array(this.exports.memory.buffer, at);
    return new TextDecoder().decode(all.subarray(0, all.indexOf(0)));
  }
  list(at) {
    const all = [];
    for (let place; (place = at(all.length)) !== 0;) all.push(this.text(place));
    return all;
  }
  number(family, index) {
    const name = this.text(this.exports.number(family, index)), [kind, low, high, standard, words] = this.told(5);
    const list = (this.text(words) || "").split("|");
    return { name, kind: dapple.kinds[kind], low, high, standard, words: list };
  }

  packed() {
    const place = this.exports.texts(), [length] = this.told(1);
    return this.bytes(place, length);
  }
  ramps() { return this.list(this.exports.ramp); }

  // null; or { column, words }.
  parse(line) {
    const given = line.replace(/[\s\0]/g, " "), bytes = new TextEncoder().encode(given);
    if (bytes.length >= this.room)
      return { column: this.room, words: `a recipe has at most ${this.room - 1} characters` };
    const buffer = this.bytes(this.exports.text(), this.room);
    buffer.set(bytes);
    buffer[bytes.length] = 0;
    const status = this.exports.parse(this.recipe);
    if (status === 0) return null;
    const [at, place, length, low, high, whole, allowed] = this.told(7);
    const decode = (part) => new TextDecoder().decode(part);
    const column = decode(bytes.subarray(0, at - 1)).length + 1, word = decode(this.bytes(place, length));
    const told = { status, column, word, low, high, whole, allowed: this.text(allowed) };
    return { column, words: dappleWords.trouble(given, told, this) };
  }

  // What a domain, { plane, x, y, width, height }, needs: { status, bytes, halo, width, height, multiple }.
  need(d, seed = 0, memory = 0, room = 0) {
    const { texture, recipe } = this;
    const status = this.exports.begin(texture, recipe, +d.plane, d.x, d.y, d.width, d.height, seed, memory, room);
    const [bytes, halo, width, height, multiple] = this.told(5);
    return { status, bytes, halo, width, height, multiple };
  }
  // Words if it is refused, else null.
  refusal(d) {
    const need = this.need(d);
    return need.status === dapple.enough ? null : dappleWords.need(need.status, need, d.width, d.height, this);
  }
  // Cells that a window is grown with on every side.
  halo() { return this.need({ plane: true, x: 0, y: 0, width: 64, height: 64 }).halo; }

  // Readies a texture; words if it is refused, else null.
  begin(d, seed) {
    const words = this.refusal(d);
    if (words) return words;
    const { bytes } = this.need(d);
    this.out = (this.memory + bytes + 15) & ~15;
    if (!this.reach(this.out + 4 * d.width * d.height)) return "this browser has not enough memory for it";
    this.domain = d;
    const need = this.need(d, seed, this.memory, bytes);
    return need.status === 0 ? null : dappleWords.need(need.status, need, d.width, d.height, this);
  }
  // Whether there is more to do.
  step(rows) { return this.exports.step(this.texture, rows) === 1; }
  progress() { return this.exports.progress(this.texture) / 1000; }

  // All pixels; valid until the next call.
  pixels(view, format = dapple.formats.rgba8888) {
    const { width, height } = this.domain, row = dapple.pixelBytes[format] * width;
    for (let y = 0; y < height; ++y) this.exports.paint(this.texture, y, view, format, this.out + y * row);
    return new Uint8ClampedArray(this.exports.memory.buffer, this.out, row * height);
  }
  // FNV-1a over the field, four bytes a cell, row by row.
  fieldHash() {
    const { width, height } = this.domain, cells = new Int32Array(width * height);
    for (let y = 0; y < height; ++y) {
      this.exports.field(this.texture, y, this.out);
      cells.set(new Int16Array(this.exports.memory.buffer, this.out, width), y * width);
    }
    return dapple.hash(new Uint8Array(cells.buffer));
  }
};
