// The list of layers: what each mark means, and a box to show or hide them.

import { drawSample, sharpen } from "./draw.js";

const SAMPLE = { width: 30, height: 14 }; // [px]

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function entry(look) {
  const canvas = element("canvas");
  canvas.style.width = `${SAMPLE.width}px`;
  canvas.style.height = `${SAMPLE.height}px`;
  drawSample(sharpen(canvas, SAMPLE.width, SAMPLE.height), look, SAMPLE.width, SAMPLE.height);
  return element("li", {}, canvas, look.label);
}

export class Legend {
  // `toggled(id, shown)` is called when somebody shows or hides a layer.
  constructor(root, legend, toggled) {
    this.rows = new Map(); // id: {row, box}
    this.toggled = toggled;
    // What is drawn last is on top, in the list too.
    for (const { id, title, key } of legend.layers.toReversed()) {
      const box = element("input", { type: "checkbox", checked: true, id: `layer-${id}` });
      box.addEventListener("change", () => this.show(id, box.checked));
      const label = element("label", {}, box, title, element("kbd", { textContent: key }));
      const marks = legend.marks.filter((mark) => mark.layer === id).map(entry);
      const row = element("div", { className: "layer empty" }, label, element("ul", {}, ...marks));
      root.append(row);
      this.rows.set(id, { row, box });
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

  setEmpty(id, empty) {
    this.rows.get(id).row.classList.toggle("empty", empty);
  }
}
