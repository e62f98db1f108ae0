// Where textures grow: in a worker, so that growing never holds up a frame; where there is none, in slices between frames.
// This file runs on both sides. Orders go in, answers come out; an order replaces the one of its kind before it.
//   { kind: "plane", order, recipe, seed, side, view }, then { kind: "want", order, wanted: [[cx, cy] ...], heard }, nearest first,
//   heard being the number of answers that had come by then
//       answers { kind: "chunk", order, cx, cy, pixels } for each
//   { kind: "tile", order, recipe, seed, width, height, view }, then { kind: "view", order, view }
//       answers { kind: "tile", order, share, more, pixels? } as it grows
//   { kind: "file", order, recipe, domain, seed, view, format }
//       answers { kind: "file", order, share }, at last with pixels
// What is refused is answered with words. pixels are an ArrayBuffer.
// SPDX-License-Identifier: MIT
"use strict";

class Grower {
  constructor(makeDesk, answer) {
    this.answer = answer;
    this.desks = { plane: makeDesk(), tile: makeDesk(), file: makeDesk() };
    this.plane = this.tile = this.file = null;
    this.rows = 64;  // a slice of work; adapts to the speed
  }

  take(m) {
    if (m.kind === "want") {
      if (this.plane && this.plane.order === m.order) this.want(this.plane, m);
      return;
    }
    if (m.kind === "view") {
      if (!this.tile || this.tile.order !== m.order) return;
      this.tile.view = m.view;
      return this.show(this.tile);
    }
    if (m.kind !== "file") this.plane = this.tile = null;  // one ground is looked at
    const job = { ...m, wanted: [], sent: [], heard: 0, at: null, growing: false, shown: 0, pause: 120 };
    const trouble = this.desks[m.kind].parse(m.recipe);
    if (trouble) return this.refuse(job, trouble.words);
    this[m.kind] = job;
    if (m.kind === "tile") this.open(job, { plane: false, x: 0, y: 0, width: m.width, height: m.height });
    if (m.kind === "file") this.open(job, m.domain);
  }

  // Chunks whose answers are on their way are wanted no more.
  want(job, m) {
    job.sent.splice(0, m.heard - job.heard);
    job.heard = m.heard;
    job.wanted = m.wanted.filter(([cx, cy]) => !job.sent.includes(cx + "," + cy));
  }

  refuse(job, words) {
    this[job.kind] = null;
    this.answer({ kind: job.kind, order: job.order, words });
  }
  open(job, domain) {
    const words = this.desks[job.kind].begin(domain, job.seed);
    job.growing = words === null;
    if (words) this.refuse(job, words);
    return words === null;
  }

  // Works until `deadline` (performance.now()); whether there is more.
  work(deadline) {
    do {
      const job = this.nextJob();
      if (!job) return false;
      const begun = performance.now();
      if (job.kind === "plane") this.growChunk(job);
      else this.growWhole(job);
      const took = performance.now() - begun;
      if (took < 0.5) this.rows = Math.min(1 << 20, this.rows * 2);
      else if (took > 2) this.rows = Math.max(1, this.rows >> 1);
    } while (performance.now() < deadline);
    return this.nextJob() !== null;
  }
  nextJob() {
    if (this.plane && (this.plane.at || this.plane.wanted.length > 0)) return this.plane;
    if (this.tile && this.tile.growing) return this.tile;
    return this.file;
  }

  growChunk(job) {
    const desk = this.desks.plane, { side } = job;
    if (job.at && !job.wanted.some(([cx, cy]) => cx === job.at[0] && cy === job.at[1])) job.at = null;  // out of sight
    if (!job.at) {
      if (job.wanted.length === 0) return;
      job.at = job.wanted[0];
      return void this.open(job, { plane: true, x: job.at[0] * side, y: job.at[1] * side, width: side, height: side });
    }
    if (desk.step(this.rows)) return;
    const [cx, cy] = job.at;
    job.at = null;
    job.wanted = job.wanted.filter((w) => w[0] !== cx || w[1] !== cy);
    job.sent.push(cx + "," + cy);
    this.answer({ kind: "chunk", order: job.order, cx, cy, pixels: desk.pixels(job.view).slice().buffer });
  }

  growWhole(job) {
    const desk = this.desks[job.kind];
    job.growing = desk.step(this.rows);
    if (job.kind === "tile") {
      if (!job.growing || performance.now() - job.shown > job.pause) this.show(job);
    } else if (job.growing) {
      if (performance.now() - job.shown < job.pause) return;
      job.shown = performance.now();
      this.answer({ kind: "file", order: job.order, share: desk.progress() });
    } else {
      this.file = null;
      this.answer({ kind: "file", order: job.order, share: 1, pixels: desk.pixels(job.view, job.format).slice().buffer });
    }
  }

  // The tile as it stands. Large ones take a while to paint, so they are shown less often.
  show(job) {
    const begun = performance.now(), desk = this.desks.tile;
    const pixels = desk.pixels(job.view).slice().buffer;
    this.answer({ kind: "tile", order: job.order, share: desk.progress(), more: job.growing, pixels });
    job.shown = performance.now();
    job.pause = Math.max(120, 6 * (job.shown - begun));
  }
}

// The worker's side: orders come in between slices.
function serve(module) {
  const told = [], turn = new MessageChannel();
  let grower = null, working = false;
  const go = () => {
    if (working || !grower) return;
    working = true;
    turn.port2.postMessage(0);
  };
  turn.port1.onmessage = () => {
    working = false;
    if (grower.work(performance.now() + 8)) go();
  };
  self.onmessage = (event) => {
    if (!grower) return void told.push(event.data);
    grower.take(event.data);
    go();
  };
  dapple.load(module).then((makeDesk) => {
    grower = new Grower(makeDesk, (answer) => self.postMessage(answer, answer.pixels ? [answer.pixels] : []));
    told.forEach((m) => grower.take(m));
    go();
  });
}

// The page's side. `hear` gets the answers; `lost` is called when a worker that had begun ends, and orders must be given anew.
class Growing {
  constructor(module, makeDesk, hear, lost) {
    this.here = () => {
      this.worker = null;
      this.grower = new Grower(makeDesk, hear);
    };
    try {
      const parts = [...document.querySelectorAll("script[data-worker]")].map((s) => s.textContent);
      if (parts.some((text) => text === "")) throw new Error("the scripts are not in the page");
      const source = new Blob([...parts, "\nserve(", JSON.stringify(module), ");"], { type: "text/javascript" });
      this.worker = new Worker(URL.createObjectURL(source));
      this.worker.onmessage = (event) => hear(event.data);
      this.worker.onerror = (event) => {
        event.preventDefault();
        this.here();
        lost();
      };
    } catch (error) {
      this.here();
    }
  }

  order(m) {
    if (this.worker) this.worker.postMessage(m);
    else this.grower.take(m);
  }

  // A frame's share of the work, where there is no worker.
  work(deadline) {
    if (this.grower) this.grower.work(deadline);
  }
}
