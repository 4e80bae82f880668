// The scene on the canvas: draws it, measures it, and finds what is under the pointer.

import { drawLabel, drawMark, drawScaleBar, sharpen } from "./draw.js";
import { placer } from "./view.js";

const REACH = 8; // [px] from the pointer to what it points at

export class Picture {
  constructor(canvas, view, legend) {
    Object.assign(this, { canvas, view, legend });
    this.hidden = new Set(); // ids of layers
    this.scene = { poses: {}, robot: [0, 0, 0] };
    this.layers = new Map(); // id: items
  }

  // Calls use(look, places, item) for each item that is shown, the lowest first.
  forEach(use) {
    for (const { id } of this.legend.layers) {
      if (this.hidden.has(id) || !this.layers.has(id)) continue;
      const place = placer(this.view, this.scene.poses[id] ?? [0, 0, 0]);
      for (const item of this.layers.get(id)) {
        const places = [];
        for (let i = 0; i < item[1].length; i += 2) places.push(place(item[1][i], item[1][i + 1]));
        use(this.legend.marks[item[0]], places, item);
      }
    }
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.view.size = { width, height };
    const context = sharpen(this.canvas, width, height);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, width, height);
    const labels = [];
    this.forEach((look, places, item) => {
      drawMark(context, look, places);
      if (item[3]) labels.push([item[3], middle(places), look.colour]);
    });
    for (const [text, place, colour] of labels) drawLabel(context, text, place, colour);
    drawScaleBar(context, this.view);
  }

  // The box around what is shown [m]: single beams that went astray count only where there is
  // nothing else; none where nothing is.
  box() {
    return this.boxOf(({ layer }) => layer !== "beams" && layer !== "robot") ?? this.boxOf(() => true);
  }

  boxOf(counts) {
    const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
    this.forEach((look, places) => {
      if (!counts(look)) return;
      for (const { x, y } of places.map((place) => this.view.toScene(place.x, place.y))) {
        box.left = Math.min(box.left, x);
        box.right = Math.max(box.right, x);
        box.bottom = Math.min(box.bottom, y);
        box.top = Math.max(box.top, y);
      }
    });
    return box.left <= box.right ? box : null;
  }

  // What the topmost thing near a place on the screen is; empty: nothing is there.
  textAt(x, y) {
    let nearest = REACH, text = "";
    this.forEach((look, places, item) => {
      if (!item[2]) return;
      const away = distanceTo(look, places, x, y);
      if (away <= nearest) [nearest, text] = [Math.max(away, 1), item[2]];
    });
    return text;
  }
}

function middle(places) {
  return { x: (places[0].x + places.at(-1).x) / 2, y: (places[0].y + places.at(-1).y) / 2 };
}

function distanceTo(look, places, x, y) {
  const joins = ["line", "polygon", "arrow"].includes(look.shape);
  if (!joins) {
    const fromMiddles = places.map((place) => Math.hypot(place.x - x, place.y - y));
    return Math.max(0, Math.min(...fromMiddles) - look.width);
  }
  if (look.shape === "polygon" && isInside(places, x, y)) return REACH; // its edges come before it
  const ends = look.shape === "polygon" ? [...places, places[0]] : places;
  let nearest = Infinity;
  for (let i = 1; i < ends.length; ++i)
    nearest = Math.min(nearest, distanceToSegment(ends[i - 1], ends[i], x, y));
  return nearest;
}

function isInside(corners, x, y) {
  let inside = false;
  corners.forEach((a, i) => {
    const b = corners.at(i - 1);
    if (a.y > y !== b.y > y && x < a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
  });
  return inside;
}

function distanceToSegment(a, b, x, y) {
  const dx = b.x - a.x, dy = b.y - a.y;
  const along = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1);
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
}
