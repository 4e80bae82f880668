// Which part of the scene is on the screen. Scene: metres, y up. Screen: CSS pixels, y down.

const MARGIN = 1.1; // about everything that is fitted in
const NEAREST = 2000, FARTHEST = 2; // [px/m]

export class View {
  scale = 60; // [px/m]
  centre = { x: 0, y: 0 }; // [m]
  size = { width: 1, height: 1 }; // [px]

  toScreen(x, y) {
    return {
      x: this.size.width / 2 + this.scale * (x - this.centre.x),
      y: this.size.height / 2 - this.scale * (y - this.centre.y),
    };
  }

  toScene(x, y) {
    return {
      x: this.centre.x + (x - this.size.width / 2) / this.scale,
      y: this.centre.y - (y - this.size.height / 2) / this.scale,
    };
  }

  pan(dx, dy) {
    this.centre.x -= dx / this.scale;
    this.centre.y += dy / this.scale;
  }

  // What is at (x, y) on the screen stays there.
  zoom(factor, x, y) {
    const fixed = this.toScene(x, y);
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, this.scale * factor));
    const moved = this.toScene(x, y);
    this.centre.x += fixed.x - moved.x;
    this.centre.y += fixed.y - moved.y;
  }

  fit(box) {
    this.centre = { x: (box.left + box.right) / 2, y: (box.bottom + box.top) / 2 };
    const across = Math.max(1, box.right - box.left), up = Math.max(1, box.top - box.bottom);
    const fitting = Math.min(this.size.width / across, this.size.height / up) / MARGIN;
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, fitting));
  }
}

// From millimetres in a layer's frame to the screen.
export function placer(view, [x, y, a]) {
  const along = Math.cos(a) / 1000, across = Math.sin(a) / 1000;
  return (px, py) => view.toScreen(x + along * px - across * py, y + across * px + along * py);
}
