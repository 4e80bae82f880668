// The list of layers: what each mark means, and a box to show or hide them.

import { drawSample, sharpen } from "./draw.js";

const SAMPLE = { width: 30, height: 14 }; // [px]

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// Hidden until the picture has such a mark.
function entry(look) {
  const canvas = element("canvas");
  canvas.style.width = `${SAMPLE.width}px`;
  canvas.style.height = `${SAMPLE.height}px`;
  drawSample(sharpen(canvas, SAMPLE.width, SAMPLE.height), look, SAMPLE.width, SAMPLE.height);
  return element("li", { className: "absent" }, canvas, look.label);
}

export class Legend {
  // `toggled(id, shown)` is called when somebody shows or hides a layer.
  constructor(root, legend, toggled) {
    this.rows = new Map(); // id: {row, box, entries}; an entry for each number of a mark
    this.toggled = toggled;
    // What is drawn last is on top, in the list too.
    for (const { id, title, key } of legend.layers.toReversed()) {
      const box = element("input", { type: "checkbox", checked: true, id: `layer-${id}` });
      box.addEventListener("change", () => this.show(id, box.checked));
      const label = element("label", {}, box, title, element("kbd", { textContent: key }));
      const entries = new Map();
      legend.marks.forEach((mark, number) => mark.layer === id && entries.set(number, entry(mark)));
      const list = element("ul", {}, ...entries.values());
      const row = element("div", { className: "layer empty" }, label, list);
      root.append(row);
      this.rows.set(id, { row, box, entries });
    }
  }

  show(id, shown) {
    const { row, box } = this.rows.get(id);
    box.checked = shown;
    row.classList.toggle("off", !shown);
    this.toggled(id, shown);
  }

  toggle(id) {
    this.show(id, !this.rows.get(id).box.checked);
  }

  // A mark that was in the picture once stays explained.
  explain(id, items) {
    const { row, entries } = this.rows.get(id);
    row.classList.toggle("empty", items.length === 0);
    for (const [mark] of items) entries.get(mark).classList.remove("absent");
  }
}
