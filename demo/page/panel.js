// The numbers of a recipe as controls. They are made from what the module says of its families, so that a new one needs
// nothing here; they read and write the recipe's line, which stays the one place where it stands.
// SPDX-License-Identifier: MIT
"use strict";

// The words of a line's first stage, and of the rest, which begins with "then".
function stagesOf(line) {
  const words = line.trim().split(/\s+/), then = words.indexOf("then");
  return then < 0 ? { first: words, rest: [] } : { first: words.slice(0, then), rest: words.slice(then) };
}
function valueIn(line, key) {
  const word = stagesOf(line).first.find((w) => w.startsWith(key + "="));
  return word === undefined ? null : word.slice(key.length + 1);
}

// Keys that say the same thing another way.
const kRivals = { scale: ["wavelength"], angle: ["angles"] };

// The line with key=value in its first stage.
function withValue(line, key, value) {
  const { first, rest } = stagesOf(line), rivals = (kRivals[key] || []).map((k) => k + "=");
  const kept = first.filter((w) => !rivals.some((r) => w.startsWith(r))), at = kept.findIndex((w) => w.startsWith(key + "="));
  if (at < 0) kept.push(key + "=" + value);
  else kept[at] = key + "=" + value;
  return [...kept, ...rest].join(" ");
}

class Panel {
  // changed(line): a control wrote a new line.
  constructor(box, desk, changed) {
    this.box = box;
    this.families = desk.families;
    this.ramps = desk.ramps();
    this.changed = changed;
    this.line = "";
    this.family = null;
    this.controls = [];
    this.rows = {};
    this.words = document.createElement("p");  // beside the number written last, if the line is refused for it
    this.words.className = "trouble";
    this.words.setAttribute("role", "alert");
  }

  // Shows a line that has been read.
  show(line) {
    const family = this.families.find((f) => f.name === stagesOf(line).first[0]);
    this.line = line;
    if (family !== this.family) this.build(family);
    for (const show of this.controls) show();
    this.tell("");
  }
  tell(words) { this.words.textContent = words; }
  write(key, value) {
    this.line = withValue(this.line, key, value);
    this.rows[key === "angles" ? "angle" : key].after(this.words);
    for (const show of this.controls) show();
    this.changed(this.line);
  }

  build(family) {
    this.family = family;
    this.controls = [];
    this.rows = {};
    this.box.replaceChildren();
    const names = this.families.map((f) => f.name);
    this.choice("family", "the model; another one begins with its own numbers", names, () => family.name, (name) => this.changed(name));
    for (const n of family.numbers) this.number(n);
    const steps = { name: "steps", kind: "integer", low: 0, standard: family.steps, unit: "how long it grows" };
    this.number({ ...steps, high: () => this.reach(family.steps) });
    this.choice("ramp", "the colours", this.ramps, () => valueIn(this.line, "ramp") || this.ramps[0], (name) => this.write("ramp", name));
    const part = { kind: "decimal", low: 0, standard: 0 };
    this.number({ ...part, name: "light", high: 10e6, unit: "how steep the slopes look" });
    this.number({ ...part, name: "gloss", high: 1e6, unit: "strength of the highlight" });
    this.number({ ...part, name: "grain", high: 1e6, unit: "noise of the brightness" });
  }
  // Steps have no end worth showing: twice what there is.
  reach(standard) {
    return 2 ** Math.ceil(Math.log2(Math.max(standard, Number(valueIn(this.line, "steps")) || 0) * 1.5 + 8));
  }

  row(name, title, ...fields) {
    const label = document.createElement("label");
    label.htmlFor = fields[0].id = "n-" + name;
    label.textContent = name;
    label.title = title || "";
    const row = document.createElement("div");
    row.className = "number";
    row.append(label, ...fields);
    this.rows[name] = row;
    this.box.append(row);
  }

  choice(name, title, words, get, set) {
    const select = document.createElement("select");
    for (const word of words) select.add(new Option(word, word));
    select.add(new Option("its own", ""));
    select.lastChild.hidden = true;
    select.addEventListener("change", () => set(select.value));
    this.row(name, title, select);
    this.controls.push(() => (select.value = words.includes(get()) ? get() : ""));
  }

  number(n) {
    const get = () => valueIn(this.line, n.name) ?? (n.kind === "angles" ? valueIn(this.line, "angles") : null);
    const one = n.kind === "integer" ? 1 : 1e6;
    if (n.kind === "word")
      return this.choice(n.name, n.unit, n.words, () => get() ?? n.words[n.standard], (word) => this.write(n.name, word));
    const text = document.createElement("input");
    text.spellcheck = false;
    text.addEventListener("input", () => {
      if (text.value.trim() !== "") this.write(n.kind === "angles" && text.value.includes(",") ? "angles" : n.name, text.value.trim().replace(/\s/g, ""));
    });
    const standard = () => (n.kind === "program" ? "0x" + (n.standard >>> 0).toString(16).padStart(8, "0") : String(n.standard / one));
    const unknown = () => (n.name === "scale" && valueIn(this.line, "wavelength") !== null ? "" : standard());
    this.controls.push(() => document.activeElement === text || (text.value = get() ?? unknown()));
    if (n.kind === "program") return this.row(n.name, n.unit, text);
    const slider = document.createElement("input");
    slider.type = "range";
    text.setAttribute("aria-label", n.name + " as text");
    slider.addEventListener("input", () => this.write(n.name, slider.value));
    this.controls.push(() => {
      const high = typeof n.high === "function" ? n.high() : n.high / one, low = n.low / one;
      slider.min = low;
      slider.max = high;
      slider.step = n.kind === "integer" ? 1 : 10 ** Math.floor(Math.log10((high - low) / 200));
      if (document.activeElement !== slider) slider.value = parseFloat(get() ?? standard());
    });
    this.row(n.name, n.unit, slider, text);
  }
}
