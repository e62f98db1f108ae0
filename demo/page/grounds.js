// What the camera sees: the endless plane in chunks, or one tile repeated. Both grow in slices and draw what there is.
// SPDX-License-Identifier: MIT
"use strict";

// Works in slices until `deadline` (performance.now()): slice(rows) answers whether there is more. Rows adapt to the speed.
function workUntil(deadline, state, slice) {
  let more = true;
  while (more && performance.now() < deadline) {
    const begun = performance.now();
    more = slice(state.rows);
    const took = performance.now() - begun;
    if (took < 0.5) state.rows = Math.min(1 << 20, state.rows * 2);
    else if (took > 2) state.rows = Math.max(1, state.rows >> 1);
  }
  return more;
}

function canvasOf(width, height, pixels) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  if (pixels) canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
  return canvas;
}

// Draws pictures of width x height cells, at(cx, cy) or nothing, over all that the camera sees.
function drawGrid(context, camera, width, height, at) {
  const { left, top } = camera.sight(), z = camera.zoom, screen = context.canvas;
  const pixel = (cell, from) => Math.round((cell - from) * z);
  context.imageSmoothingEnabled = z < 1;
  const right = left + screen.width / z, bottom = top + screen.height / z;
  for (let cy = Math.floor(top / height); cy * height < bottom; ++cy)
    for (let cx = Math.floor(left / width); cx * width < right; ++cx) {
      const x = pixel(cx * width, left), y = pixel(cy * height, top);
      const picture = at(cx, cy);
      if (picture) context.drawImage(picture, x, y, pixel((cx + 1) * width, left) - x, pixel((cy + 1) * height, top) - y);
    }
}

class Plane {
  constructor(desk) {
    this.desk = desk;
    this.pace = { rows: 64 };
  }

  // Words if the recipe is refused.
  begin(setup, camera) {
    const refused = this.desk.parse(setup.recipe);
    if (refused) return refused.words;
    this.setup = setup;
    const side = this.desk.halo() <= 140 ? 128 : 256;
    const sight = camera.sight(), across = Math.ceil(sight.width / side) + 2, down = Math.ceil(sight.height / side) + 2;
    const words = this.desk.beginChunks(setup.seed, side, Math.min(60000, Math.ceil(across * down * 1.5)), setup.view);
    this.pictures = new Map();
    this.side = side;
    this.far = false;
    return words;
  }

  // Whether anything changed.
  work(camera, deadline) {
    const s = camera.sight(), desk = this.desk;
    const status = desk.lookAt(s.x, s.y, s.width, s.height);
    if (status === -15) {  // a larger view than there are slots for
      this.begin(this.setup, camera);
      return true;
    }
    this.far = status < 0;
    if (this.far || desk.missing() === 0) return false;
    const before = desk.missing();
    workUntil(deadline, this.pace, (rows) => desk.stepChunks(rows));
    return desk.missing() !== before;
  }

  draw(context, camera) {
    drawGrid(context, camera, this.side, this.side, (cx, cy) => this.picture(cx, cy));
    if (this.pictures.size <= this.desk.slots) return;
    for (const key of this.pictures.keys()) {
      const [cx, cy] = key.split(",").map(Number);
      if (!this.desk.chunk(cx, cy)) this.pictures.delete(key);
    }
  }

  picture(cx, cy) {
    const key = cx + "," + cy;
    let picture = this.pictures.get(key);
    if (picture) return picture;
    const pixels = this.desk.chunk(cx, cy);
    if (!pixels) return null;
    picture = canvasOf(this.side, this.side, pixels);
    this.pictures.set(key, picture);
    return picture;
  }

  repaint(view, camera) {
    this.setup.view = view;
    this.begin(this.setup, camera);
  }

  words() {
    if (this.far) return "the plane ends here";
    const missing = this.desk.missing();
    return missing === 0 ? "" : missing + (missing === 1 ? " chunk" : " chunks") + " to grow";
  }
  settled() { return this.far || this.desk.missing() === 0; }
}

class Tile {
  constructor(desk) {
    this.desk = desk;
    this.pace = { rows: 64 };
  }

  begin(setup) {
    const refused = this.desk.parse(setup.recipe);
    if (refused) return refused.words;
    this.setup = setup;
    const words = this.desk.begin({ plane: false, x: 0, y: 0, width: setup.width, height: setup.height }, setup.seed);
    if (words) return words;
    this.picture = canvasOf(setup.width, setup.height);
    this.growing = true;
    this.painted = 0;
    return null;
  }

  work(camera, deadline) {
    if (!this.growing) return false;
    this.growing = workUntil(deadline, this.pace, (rows) => this.desk.step(rows));
    if (this.growing && performance.now() - this.painted < 120) return false;
    this.paint();
    return true;
  }

  paint() {
    const pixels = this.desk.pixels(this.setup.view);
    this.picture.getContext("2d").putImageData(new ImageData(pixels, this.setup.width, this.setup.height), 0, 0);
    this.painted = performance.now();
  }
  repaint(view) {
    this.setup.view = view;
    this.paint();
  }

  draw(context, camera) {
    drawGrid(context, camera, this.setup.width, this.setup.height, () => this.picture);
  }
  words() { return this.growing ? Math.floor(100 * this.desk.progress()) + " % grown" : ""; }
  settled() { return !this.growing; }
}
