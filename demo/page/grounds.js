// What the camera sees: the endless plane in chunks, or one tile repeated. Both order what is missing and draw what there is.
// SPDX-License-Identifier: MIT
"use strict";

function canvasOf(width, height, pixels) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  if (pixels) put(canvas, pixels);
  return canvas;
}
function put(canvas, pixels) {
  canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(pixels), canvas.width, canvas.height), 0, 0);
}

// Chunks in sight: [left, top, right, bottom], both ends included.
function chunksInSight(camera, width, height) {
  const { left, top } = camera.sight(), { canvas, zoom } = camera;
  const last = (from, cells, side) => Math.ceil((from + cells) / side) - 1;
  return [Math.floor(left / width), Math.floor(top / height), last(left, canvas.width / zoom, width), last(top, canvas.height / zoom, height)];
}

// Draws pictures of width x height cells, at(cx, cy) or nothing, over all that the camera sees.
function drawGrid(context, camera, width, height, at) {
  const { left, top } = camera.sight(), z = camera.zoom, [x0, y0, x1, y1] = chunksInSight(camera, width, height);
  const pixel = (cell, from) => Math.round((cell - from) * z);
  context.imageSmoothingEnabled = z < 1;
  for (let cy = y0; cy <= y1; ++cy)
    for (let cx = x0; cx <= x1; ++cx) {
      const x = pixel(cx * width, left), y = pixel(cy * height, top), picture = at(cx, cy);
      if (picture) context.drawImage(picture, x, y, pixel((cx + 1) * width, left) - x, pixel((cy + 1) * height, top) - y);
    }
}

let orders = 0;  // so that answers to what is no longer wanted are known

class Plane {
  constructor(growing) {
    this.growing = growing;
    this.pictures = new Map();
    this.side = 0;
    this.missing = [];
  }

  // What is there stays in sight until what is ordered has come.
  begin(setup) {
    const side = setup.halo <= 140 ? 128 : 256;
    this.before = { side: this.side, pictures: this.pictures };
    this.side = side;
    this.setup = setup;
    this.pictures = new Map();
    this.asked = "";
    this.heard = 0;
    this.order = ++orders;
    this.growing.order({ kind: "plane", order: this.order, recipe: setup.recipe, seed: setup.seed, side, view: setup.view });
  }
  repaint() { this.begin(this.setup); }

  // Orders what is in sight and missing, the nearest to the middle first.
  look(camera) {
    const [x0, y0, x1, y1] = chunksInSight(camera, this.side, this.side), missing = [];
    for (let cy = y0; cy <= y1; ++cy)
      for (let cx = x0; cx <= x1; ++cx) if (!this.pictures.has(cx + "," + cy)) missing.push([cx, cy]);
    const far = ([cx, cy]) => Math.hypot((cx + 0.5) * this.side - camera.x, (cy + 0.5) * this.side - camera.y);
    missing.sort((a, b) => far(a) - far(b));
    this.missing = missing;
    const asked = missing.join(" ");
    if (asked === this.asked) return;
    this.asked = asked;
    this.growing.order({ kind: "want", order: this.order, wanted: missing, heard: this.heard });
    this.forget(2 * (x1 - x0 + 1) * (y1 - y0 + 1) + 64);
  }

  // The pictures longest not drawn make room.
  forget(most) {
    for (const key of this.pictures.keys()) {
      if (this.pictures.size <= most) return;
      this.pictures.delete(key);
    }
  }

  hear(answer) {
    ++this.heard;
    this.pictures.set(answer.cx + "," + answer.cy, canvasOf(this.side, this.side, answer.pixels));
  }

  draw(context, camera) {
    this.look(camera);
    if (this.missing.length === 0) this.before = null;
    const old = this.before;
    if (old && old.side > 0) drawGrid(context, camera, old.side, old.side, (cx, cy) => old.pictures.get(cx + "," + cy));
    drawGrid(context, camera, this.side, this.side, (cx, cy) => this.picture(cx + "," + cy));
  }
  picture(key) {
    const picture = this.pictures.get(key);
    if (!picture) return null;
    this.pictures.delete(key);  // to the end of the line
    this.pictures.set(key, picture);
    return picture;
  }

  words() {
    const count = this.missing.length;
    return count === 0 ? "" : count + (count === 1 ? " chunk" : " chunks") + " to grow";
  }
  settled() { return this.missing.length === 0; }
}

class Tile {
  constructor(growing) {
    this.growing = growing;
    this.picture = null;
  }

  begin(setup) {
    const { recipe, seed, width, height, view } = setup;
    this.setup = setup;
    this.order = ++orders;
    this.share = 0;
    this.more = true;
    this.growing.order({ kind: "tile", order: this.order, recipe, seed, width, height, view });
  }
  repaint() {
    this.more = true;
    this.growing.order({ kind: "view", order: this.order, view: this.setup.view });
  }

  hear(answer) {
    const { width, height } = this.setup;
    if (!this.picture || this.picture.width !== width || this.picture.height !== height) this.picture = canvasOf(width, height);
    put(this.picture, answer.pixels);
    this.share = answer.share;
    this.more = answer.more;
  }

  draw(context, camera) {
    if (this.picture) drawGrid(context, camera, this.picture.width, this.picture.height, () => this.picture);
  }
  words() { return this.more ? Math.floor(100 * this.share) + " % grown" : ""; }
  settled() { return !this.more; }
}
