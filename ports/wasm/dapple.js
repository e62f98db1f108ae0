// The WebAssembly module for scripts: memory laid out, text both ways. A Desk is one instance with one recipe and, over
// it, one texture or one cache of chunks; beginning anew uses the same memory again.
// SPDX-License-Identifier: MIT
"use strict";

const dapple = {
  formats: { l8: 0, rgb888: 1, rgba8888: 2, rgb565: 3 },
  views: ["colour", "field", "cells", "height", "normal", "opacity", "roughness"],

  // From base64 or bytes; a promise of what makes desks.
  async load(module) {
    const bytes = typeof module === "string" ? Uint8Array.from(atob(module), (c) => c.charCodeAt(0)) : module;
    const compiled = await WebAssembly.compile(bytes);
    return () => new dapple.Desk(new WebAssembly.Instance(compiled, {}).exports);
  },

  // FNV-1a, 64 bit, as hexadecimal digits.
  hash(bytes) {
    let hash = 0xcbf29ce484222325n;
    for (const byte of bytes) hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & 0xffffffffffffffffn;
    return hash.toString(16).padStart(16, "0");
  },
};

dapple.Desk = class {
  constructor(exports) {
    this.exports = exports;
    const after = (at, bytes) => (at + bytes + 15) & ~15;
    this.recipe = exports.heap();
    this.texture = after(this.recipe, exports.recipe_bytes());
    this.chunks = after(this.texture, exports.texture_bytes());
    this.memory = after(this.chunks, exports.chunks_bytes());
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

  text(length) {
    const all = new Uint8Array(this.exports.memory.buffer, this.exports.text(), this.exports.text_bytes());
    return new TextDecoder().decode(all.subarray(0, length === undefined ? all.indexOf(0) : length));
  }

  presets() {
    const part = (i, k) => this.text(this.exports.preset(i, k));
    return Array.from({ length: this.exports.preset_count() }, (_, i) => ({ name: part(i, 0), sentence: part(i, 1), line: part(i, 2) }));
  }

  // null; or { column, words }.
  parse(line) {
    const bytes = new TextEncoder().encode(line.replace(/[\s\0]/g, " "));
    const room = this.exports.text_bytes() - 1;
    const buffer = new Uint8Array(this.exports.memory.buffer, this.exports.text(), room + 1);
    buffer.set(bytes.subarray(0, room));
    buffer[Math.min(bytes.length, room)] = 0;
    const column = this.exports.parse(this.recipe);
    return column === 0 ? null : { column, words: this.text() };
  }

  halo() { return this.exports.halo(this.recipe); }

  // A texture: domain is { plane, x, y, width, height }. Words if it is refused, else null.
  refusal(d) {
    return this.exports.need(this.recipe, +d.plane, d.x, d.y, d.width, d.height) < 0 ? this.text() : null;
  }
  begin(d, seed) {
    const bytes = this.exports.need(this.recipe, +d.plane, d.x, d.y, d.width, d.height);
    if (bytes < 0) return this.text();
    this.out = (this.memory + bytes + 15) & ~15;
    if (!this.reach(this.out + 4 * d.width * d.height)) return "this browser has not enough memory for it";
    this.domain = d;
    const status = this.exports.begin(this.texture, this.recipe, +d.plane, d.x, d.y, d.width, d.height, seed, this.memory, bytes);
    return status === 0 ? null : this.text();
  }
  step(rows) { return this.exports.step(this.texture, rows) === 1; }
  progress() { return this.exports.progress(this.texture) / 1000; }

  // All pixels; valid until the next call.
  pixels(view, format = dapple.formats.rgba8888) {
    const { width, height } = this.domain;
    this.exports.paint(this.texture, 0, height, view, format, this.out);
    return new Uint8ClampedArray(this.exports.memory.buffer, this.out, this.exports.bytes_a_row(format, width) * height);
  }
  fieldHash() {
    let hash = 0n;
    for (let y = 0; y < this.domain.height; ++y) hash = this.exports.field_hash(this.texture, y, this.out, hash);
    return BigInt.asUintN(64, hash).toString(16).padStart(16, "0");
  }

  // A cache of chunks.
  beginChunks(seed, side, slots, view) {
    const bytes = this.exports.chunks_need(this.recipe, side, slots);
    if (bytes < 0) return this.text();
    if (!this.reach(this.memory + bytes)) return "this browser has not enough memory for it";
    this.side = side;
    this.slots = slots;
    const status = this.exports.chunks_begin(this.chunks, this.recipe, seed, side, slots, view, this.memory, bytes);
    return status === 0 ? null : "the cache of chunks cannot begin";
  }
  lookAt(x, y, width, height) { return this.exports.chunks_look_at(this.chunks, x, y, width, height); }
  stepChunks(rows) { return this.exports.chunks_step(this.chunks, rows) === 1; }
  missing() { return this.exports.chunks_missing(this.chunks); }
  chunk(cx, cy) {
    const at = this.exports.chunks_pixels(this.chunks, cx, cy);
    return at === 0 ? null : new Uint8ClampedArray(this.exports.memory.buffer, at, 4 * this.side * this.side);
  }
};
