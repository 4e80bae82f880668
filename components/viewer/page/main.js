// The page: takes scenes from the server, and what the user wants to see of them.

import { Legend } from "./legend.js";
import { Picture } from "./picture.js";
import { Timeline } from "./timeline.js";
import { View } from "./view.js";

const AGAIN = 1000; // [ms] from a lost connection to the next try
const SILENCE = 2000; // [ms] after which the page says that data stopped
const NO_CONNECTION = "No connection to pico-viewer: trying again";
const ASIDE = 14; // [px] from the pointer to what it says
const WHEEL = 1.0015; // zoom for each pixel of the wheel

const byId = (id) => document.getElementById(id);

function say(text) {
  byId("banner").textContent = text;
  byId("banner").hidden = text === "";
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function fetchLegend() {
  for (;;) {
    try {
      return await (await fetch("legend.json")).json();
    } catch {
      say(NO_CONNECTION);
      await pause(AGAIN);
    }
  }
}

const legendData = await fetchLegend();
const canvas = byId("picture");
const view = new View();
const picture = new Picture(canvas, view, legendData);
const timeline = new Timeline(byId("components"));
const legend = new Legend(byId("legend"), legendData, (id, shown) => {
  shown ? picture.hidden.delete(id) : picture.hidden.add(id);
  redraw();
});

// What the user chose, and what is known of the connection.
const page = { paused: false, follow: false, fitted: true, lastUtime: 0, lastNews: performance.now(), trouble: "" };
window.perceptor = { page, picture, view }; // for tests, and for the curious

let drawing = false;
function redraw() {
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    if (page.follow) [view.centre.x, view.centre.y] = picture.scene.robot;
    picture.draw();
    if (page.fitted && picture.box()) {
      view.fit(picture.box());
      picture.draw();
    }
    explainPointer();
  });
}

// Beside the pointer, on the side where there is room.
function explainPointer() {
  const hover = byId("hover"), at = page.pointer;
  const text = at ? picture.textAt(at.x, at.y) : "";
  hover.textContent = text;
  hover.hidden = text === "";
  if (!text) return;
  const { width, height } = view.size;
  hover.style.left = `${at.x < width / 2 ? at.x + ASIDE : at.x - ASIDE - hover.offsetWidth}px`;
  hover.style.top = `${at.y < height / 2 ? at.y + ASIDE : at.y - ASIDE - hover.offsetHeight}px`;
}

function take(parts) {
  if (parts.status) timeline.take(parts.status);
  if (parts.scene) {
    if (parts.scene.frame !== picture.scene.frame) page.fitted = !page.follow;
    picture.scene = parts.scene;
    showState();
  }
  for (const { id } of legendData.layers) {
    const items = parts[`layer.${id}`];
    if (!items) continue;
    picture.layers.set(id, items);
    legend.explain(id, items);
  }
  redraw();
}

function showState() {
  const { frame, robot, notes } = picture.scene;
  const [x, y, a] = robot;
  const where = { world: "in the building", local: "from its start", robot: "" }[frame];
  byId("state").textContent = where
    ? `Robot at ${x.toFixed(2)}, ${y.toFixed(2)} m, ${((180 * a) / Math.PI).toFixed(0)}° ${where}`
    : "The robot's own frame: no position yet";
  byId("notes").replaceChildren(...notes.map((note) => Object.assign(document.createElement("li"), { textContent: note })));
}

function watchConnection() {
  const now = performance.now();
  const silent = now - page.lastNews;
  timeline.markSilent(now);
  if (page.trouble) say(page.trouble);
  else if (silent > SILENCE) say(`No new data for ${Math.floor(silent / 1000)} s`);
  else say(page.paused ? "Paused: the picture stands still" : "");
}

// EventSource does not tell why it was turned away.
async function whyNot() {
  const asking = new AbortController();
  try {
    const reply = await fetch("scenes", { signal: asking.signal });
    return reply.ok ? NO_CONNECTION : await reply.text();
  } catch {
    return NO_CONNECTION;
  } finally {
    asking.abort();
  }
}

function connect() {
  const source = new EventSource("scenes");
  source.onopen = () => (page.trouble = "");
  source.onmessage = ({ data }) => {
    const parts = JSON.parse(data);
    if (parts.scene && parts.scene.utime !== page.lastUtime) {
      page.lastUtime = parts.scene.utime;
      page.lastNews = performance.now();
    }
    if (page.paused) page.missed = { ...page.missed, ...parts };
    else take(parts);
  };
  source.onerror = async () => {
    source.close();
    page.trouble = NO_CONNECTION;
    page.trouble = await whyNot();
    await pause(AGAIN);
    connect();
  };
}

function press(id, on) {
  byId(id).setAttribute("aria-pressed", on);
}

const actions = {
  pause() {
    page.paused = !page.paused;
    press("pause", page.paused);
    watchConnection();
    if (!page.paused && page.missed) take(page.missed);
    page.missed = undefined;
  },
  follow() {
    page.follow = !page.follow;
    page.fitted = false;
    press("follow", page.follow);
    redraw();
  },
  fit() {
    page.follow = false;
    page.fitted = true;
    press("follow", false);
    redraw();
  },
  save() {
    canvas.toBlob((png) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(png);
      link.download = `perceptor-${picture.scene.utime ?? 0}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), AGAIN);
    });
  },
  details() {
    const shown = byId("timeline").toggleAttribute("hidden");
    press("details", !shown);
    redraw();
  },
};
const keys = { " ": "pause", f: "follow", 0: "fit", s: "save", d: "details" };

for (const name of Object.keys(actions))
  byId(name).addEventListener("click", () => {
    actions[name]();
    byId(name).blur();
  });

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.repeat) return;
  const layer = legendData.layers.find(({ key }) => key === event.key);
  if (layer) legend.toggle(layer.id);
  else if (keys[event.key]) actions[keys[event.key]]();
  else return;
  event.preventDefault();
});

canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  page.fitted = false;
  view.zoom(WHEEL ** -event.deltaY, event.offsetX, event.offsetY);
  redraw();
}, { passive: false });

canvas.addEventListener("pointermove", (event) => {
  if (event.buttons & 1) {
    if (page.follow) actions.follow();
    page.fitted = false;
    view.pan(event.movementX, event.movementY);
    redraw();
  }
  page.pointer = { x: event.offsetX, y: event.offsetY };
  explainPointer();
});
canvas.addEventListener("pointerleave", () => {
  page.pointer = undefined;
  explainPointer();
});
canvas.addEventListener("dblclick", actions.fit);
new ResizeObserver(redraw).observe(canvas);
setInterval(watchConnection, 250);
connect();
