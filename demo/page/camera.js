// The camera over the plane: where it is, how close, and what fingers, mouse, wheel and keys do to it. Places are cells;
// zoom is device pixels a cell, from a short list, so that cells are drawn as even squares.
// SPDX-License-Identifier: MIT
"use strict";

class Camera {
  constructor(canvas, moved) {
    this.canvas = canvas;
    this.moved = moved;
    this.zooms = [0.5, 1, 2, 3, 4, 6, 8, 12, 16];
    this.x = this.y = 0;  // the cell in the middle
    this.zoom = Math.max(1, Math.round(2 * (window.devicePixelRatio || 1)));
    this.fingers = new Map();
    this.wheel = 0;
    this.listen();
  }

  // The left upper corner, on whole device pixels, and the size in cells.
  sight() {
    const { width, height } = this.canvas, z = this.zoom;
    const left = Math.round((this.x - width / 2 / z) * z) / z, top = Math.round((this.y - height / 2 / z) * z) / z;
    return { left, top, x: Math.floor(left), y: Math.floor(top), width: Math.ceil(width / z) + 2, height: Math.ceil(height / z) + 2 };
  }

  move(dx, dy) {
    this.place(this.x + dx, this.y + dy);
  }
  place(x, y) {
    const far = 1e9;  // the plane ends a little farther out
    this.x = Math.max(-far, Math.min(far, x));
    this.y = Math.max(-far, Math.min(far, y));
    this.moved();
  }

  // Some steps closer, or farther; the cell under (px, py), device pixels from the middle, stays there.
  zoomBy(steps, px = 0, py = 0) {
    const nearest = (a, b) => (Math.abs(this.zooms[b] - this.zoom) < Math.abs(this.zooms[a] - this.zoom) ? b : a);
    const now = this.zooms.map((_, i) => i).reduce(nearest);
    const next = this.zooms[Math.max(0, Math.min(this.zooms.length - 1, now + steps))];
    const dx = px / this.zoom - px / next, dy = py / this.zoom - py / next;
    this.zoom = next;
    this.move(dx, dy);
  }

  // Device pixels from the middle.
  at(event) {
    const box = this.canvas.getBoundingClientRect(), scale = this.canvas.width / Math.max(1, box.width);
    return { x: (event.clientX - box.left - box.width / 2) * scale, y: (event.clientY - box.top - box.height / 2) * scale };
  }

  listen() {
    const on = (name, does) => this.canvas.addEventListener(name, does, { passive: false });
    on("pointerdown", (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      this.canvas.classList.add("dragged");
      this.fingers.set(e.pointerId, this.at(e));
      this.pinch = null;
    });
    on("pointermove", (e) => this.fingers.has(e.pointerId) && this.drag(e));
    for (const name of ["pointerup", "pointercancel"])
      on(name, (e) => {
        this.fingers.delete(e.pointerId);
        this.pinch = null;
        if (this.fingers.size === 0) this.canvas.classList.remove("dragged");
      });
    on("wheel", (e) => {
      e.preventDefault();
      this.wheel += e.deltaY * (e.deltaMode === 1 ? 30 : 1);
      if (Math.abs(this.wheel) < 40) return;
      const p = this.at(e);
      this.zoomBy(this.wheel < 0 ? 1 : -1, p.x, p.y);
      this.wheel = 0;
    });
    on("keydown", (e) => this.key(e));
  }

  drag(event) {
    const was = this.fingers.get(event.pointerId), now = this.at(event), share = this.fingers.size;
    this.fingers.set(event.pointerId, now);
    this.move((was.x - now.x) / this.zoom / share, (was.y - now.y) / this.zoom / share);
    if (share !== 2) return;
    const [a, b] = [...this.fingers.values()], apart = Math.hypot(a.x - b.x, a.y - b.y);
    if (!this.pinch) this.pinch = apart;
    const steps = apart > this.pinch * 1.4 ? 1 : apart < this.pinch / 1.4 ? -1 : 0;
    if (steps === 0) return;
    this.zoomBy(steps, (a.x + b.x) / 2, (a.y + b.y) / 2);
    this.pinch = apart;
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = (event.shiftKey ? 320 : 64) / this.zoom;
    const does = {
      ArrowLeft: () => this.move(-step, 0), ArrowRight: () => this.move(step, 0),
      ArrowUp: () => this.move(0, -step), ArrowDown: () => this.move(0, step),
      "+": () => this.zoomBy(1), "=": () => this.zoomBy(1), "-": () => this.zoomBy(-1), Home: () => this.place(0, 0),
    }[event.key];
    if (!does) return;
    event.preventDefault();
    does();
  }
}
