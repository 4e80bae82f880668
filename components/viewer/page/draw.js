// Marks on a canvas, at places in CSS pixels.

const ARROW_HEAD = 0.45; // [rad] of each barb from the shaft
const SHORTEST_BAR = 60; // [px]

function path(context, places, closed) {
  context.beginPath();
  places.forEach((place, i) => (i ? context.lineTo(place.x, place.y) : context.moveTo(place.x, place.y)));
  if (closed) context.closePath();
}

function symbol(context, shape, { x, y }, size) {
  context.beginPath();
  if (shape === "dot" || shape === "ring") context.arc(x, y, size, 0, 2 * Math.PI);
  if (shape === "square") context.rect(x - size, y - size, 2 * size, 2 * size);
  if (shape === "triangle") {
    context.moveTo(x, y - size);
    context.lineTo(x + size, y + size);
    context.lineTo(x - size, y + size);
    context.closePath();
  }
  if (shape === "cross") {
    context.moveTo(x - size, y - size);
    context.lineTo(x + size, y + size);
    context.moveTo(x - size, y + size);
    context.lineTo(x + size, y - size);
  }
  if (shape === "ring" || shape === "cross") context.stroke();
  else context.fill();
}

function arrow(context, from, to, size) {
  path(context, [from, to], false);
  const angle = Math.atan2(to.y - from.y, to.x - from.x);
  for (const barb of [-ARROW_HEAD, ARROW_HEAD]) {
    context.moveTo(to.x, to.y);
    context.lineTo(to.x - size * Math.cos(angle + barb), to.y - size * Math.sin(angle + barb));
  }
  context.stroke();
}

export function drawMark(context, look, places) {
  context.strokeStyle = context.fillStyle = look.colour;
  context.lineWidth = look.shape === "line" || look.shape === "polygon" ? look.width : 2;
  context.setLineDash(look.dash ? [look.dash, look.dash] : []);
  if (look.shape === "polygon") {
    path(context, places, true);
    context.globalAlpha = look.fill;
    context.fill();
    context.globalAlpha = 1;
    if (look.width) context.stroke();
  } else if (look.shape === "line") {
    path(context, places, false);
    context.stroke();
  } else if (look.shape === "arrow") {
    arrow(context, places[0], places[1], look.width);
  } else {
    for (const place of places) symbol(context, look.shape, place, look.width);
  }
}

export function drawLabel(context, text, { x, y }, colour) {
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.lineWidth = 4;
  context.setLineDash([]);
  context.strokeStyle = "#fff";
  context.strokeText(text, x, y - 8);
  context.fillStyle = colour;
  context.fillText(text, x, y - 8);
}

// A bar of 1, 2 or 5 times a power of ten metres.
export function drawScaleBar(context, view) {
  const power = 10 ** Math.floor(Math.log10(SHORTEST_BAR / view.scale));
  const metres = [1, 2, 5, 10].map((m) => m * power).find((m) => m * view.scale >= SHORTEST_BAR);
  const right = view.size.width - 16, y = view.size.height - 16, left = right - metres * view.scale;
  context.strokeStyle = context.fillStyle = "#111";
  context.lineWidth = 2;
  context.setLineDash([]);
  path(context, [{ x: left, y: y - 5 }, { x: left, y }, { x: right, y }, { x: right, y: y - 5 }], false);
  context.stroke();
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  context.fillText(`${+metres.toPrecision(1)} m`, (left + right) / 2, y - 6);
}

// A mark as the legend shows it, in a box of this size.
export function drawSample(context, look, width, height) {
  const y = height / 2, inset = 3;
  const corners = [[inset, inset], [width - inset, inset], [width - inset, height - inset], [inset, height - inset]];
  if (look.shape === "polygon") drawMark(context, look, corners.map(([px, py]) => ({ x: px, y: py })));
  else if (look.shape === "line" || look.shape === "arrow")
    drawMark(context, { ...look, width: Math.min(look.width, height / 2) }, [{ x: 2, y }, { x: width - 2, y }]);
  else drawMark(context, look, [{ x: width / 2, y }]);
}

// A canvas as sharp as the screen is.
export function sharpen(canvas, width, height) {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}
