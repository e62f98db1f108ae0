// What the module's answers say in words: why a recipe or a size is refused, with what was given and what is allowed.
// SPDX-License-Identifier: MIT
"use strict";

const dappleWords = {
  // Keys that every family takes, beside its own numbers.
  common: ["wavelength", "steps", "level", "levels", "fine", "solver", "start", "pitch", "aspect", "jitter", "radius",
    "amplitude", "ramp", "range", "light", "gloss", "grain", "opacity", "roughness"],

  // 1/1000000 as a decimal number.
  decimal: (micro) => String(Number((micro / 1e6).toFixed(6))),

  // As it was given, between quotation marks, shortened.
  shown(word) {
    const plain = [...word].map((c) => (c < " " || c === "\x7f" ? "?" : c));
    return "'" + plain.slice(0, 60).join("") + (plain.length > 60 ? "...'" : "'");
  },

  keys(family) {
    const own = family.numbers.flatMap((n) => (n.kind === "angles" ? [n.name, "angles"] : [n.name]));
    return own.concat(dappleWords.common).join(", ");
  },

  // Why parse refused `line`; told: { status, column, word, low, high, whole, allowed }; known: { families, limits }.
  trouble(line, told, { families, limits }) {
    const word = dappleWords.shown(told.word);
    switch (told.status) {
      case -3: {  // broken_text
        if (told.column === 1 || line[told.column - 2] === " ") return word + " is not key=value";
        if (told.word === "") return "a value is missing";
        if (told.word.includes(",")) return word + " has too many numbers";
        return word + " is not a number; numbers are decimal, with at most six digits after the point";
      }
      case -1: {  // unknown_word
        if (told.column === 1 && told.allowed === null)
          return (told.word === "" ? "the recipe is empty" : "no family is called " + word) +
            "; a recipe begins with " + families.map((f) => f.name).join(", ");
        const family = families.find((f) => f.name === told.allowed);
        if (family) return word + " is not a key of " + family.name + "; there is " + dappleWords.keys(family);
        return word + " is not one of " + (told.allowed === null ? "carry|refine|freeze|reset" : told.allowed).split("|").join(", ");
      }
      case -2: {  // out_of_range
        const number = told.whole ? String : dappleWords.decimal, all = told.word === line;
        return (all ? "the wavelength" : word) + " is out of range, " + number(told.low) + " to " + number(told.high);
      }
      case -23:  // unstable: a step that diverges, or a grid too coarse; the number is named
        return told.allowed + (told.allowed === "scale" ? " is too small for the stage's grid; the least is " + dappleWords.decimal(told.low)
          : " makes the steps diverge; the most is " + dappleWords.decimal(told.high));
      default:  // not_possible: which words exclude each other follows from the word that was met
        if (told.word === "carry") return `a recipe has at most ${limits.stages} stages`;
        if (told.word === "freeze" || told.word === "reset") return `'then ${told.word}' is for families of kinetics, at most ${limits.stages} stages`;
        if (told.word === "refine")
          return `'then refine' needs a stage of level 1 to 3 before it, and there are at most ${limits.stages} stages`;
        if (told.word === "binary") return "solver=binary is a family of its own, of one bit a cell: begin the recipe with bits";
        return "fine=F needs levels=L or solver=multigrid, and the steps must be more than F (L - 1)";
    }
  },

  // Why begin refused a domain of width x height; told: { halo, width, height, multiple }.
  need(status, told, width, height, { limits }) {
    const up = (side) => Math.ceil(side / told.multiple) * told.multiple;
    switch (status) {
      case -11: return `a side has at least ${limits.side} cells`;
      case -12: return "the sides must be multiples of " + told.multiple;
      case -13:
        return `${width} x ${height} is too small: this recipe needs at least ` +
          `${up(told.width)} x ${up(told.height)}`;
      case -14: return "more memory than there are addresses";
      case -15: return "not enough memory";
      case -19: return "map=image needs an image, which cannot be given here";
      case -23: return "a number makes the steps diverge, or is too small for its grid";
      case -21: return "sides other than sides=repeat need a patch, which cannot be given here";
      case -24: return "coverage= is a share of a whole tile, of which the endless plane has none; take the repeated tile";
      case -17: return "the plane ends here";
      case -18:
        return "not for the endless plane: it would have to grow " + told.halo + " cells more on every side, " +
          `and ${limits.halo} are the most; a repeated tile needs none`;
      default:
        return "the stages of the recipe do not fit each other; the last one must have level=0, after 'then refine'";
    }
  },
};
