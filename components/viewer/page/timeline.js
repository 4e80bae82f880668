// Rates, latency and rejects of each component over its last STATUS messages, one a second.

import { sharpen } from "./draw.js";

const KEPT = 120; // of them
const SILENT = 3000; // [ms] a component that said nothing for longer is silent
const SPARK = { width: 120, height: 18 }; // [px]

const sum = (numbers) => numbers.reduce((total, number) => total + number, 0);

// What a STATUS says, as numbers to plot; rates are those since the one before.
function sample(status, before) {
  const sent = sum(Object.values(status.published));
  const goesOn = before && before.boot === status.boot && status.utime > before.utime;
  const seconds = goesOn ? (status.utime - before.utime) / 1e6 : NaN;
  return {
    rate: goesOn ? (sent - sum(Object.values(before.published))) / seconds : NaN,
    p99: status.p99 / 1000,
    rejected: goesOn ? (status.rejected - before.rejected) / seconds : NaN,
    cpu: goesOn ? (100 * (status.cpu - before.cpu)) / seconds : NaN,
  };
}

function spark(canvas, values, colour) {
  const context = sharpen(canvas, SPARK.width, SPARK.height);
  const top = Math.max(...values.filter(Number.isFinite), 1e-9);
  context.strokeStyle = "#ddd";
  context.strokeRect(0.5, 0.5, SPARK.width - 1, SPARK.height - 1);
  context.strokeStyle = colour;
  context.beginPath();
  values.forEach((value, i) => {
    if (!Number.isFinite(value)) return;
    const x = SPARK.width - ((values.length - i) * SPARK.width) / KEPT;
    context.lineTo(x, SPARK.height - 2 - ((SPARK.height - 4) * value) / top);
  });
  context.stroke();
}

class Row {
  constructor(body, component) {
    this.history = [];
    this.row = body.insertRow();
    this.row.id = `component-${component}`;
    this.cells = Array.from({ length: 8 }, () => this.row.insertCell());
    this.cells[0].textContent = component;
    for (const i of [1, 2, 3]) {
      const canvas = document.createElement("canvas");
      canvas.style.width = `${SPARK.width}px`;
      canvas.style.height = `${SPARK.height}px`;
      this.cells[i].append(canvas, document.createElement("span"));
    }
  }

  take(status) {
    this.history.push(sample(status, this.status));
    if (this.history.length > KEPT) this.history.shift();
    this.status = status;
    this.heard = performance.now();
    this.plot();
  }

  plot() {
    const { status, history } = this, now = history.at(-1);
    const number = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : "");
    const plots = [
      ["rate", number(now.rate, 1), "#0072b2"],
      ["p99", `${number(status.p50 / 1000, 2)}, ${number(now.p99, 2)}`, "#e69f00"],
      ["rejected", String(status.rejected), "#d55e00"],
    ];
    plots.forEach(([what, text, colour], i) => {
      const [canvas, span] = this.cells[i + 1].children;
      spark(canvas, history.map((past) => past[what]), colour);
      span.textContent = text;
    });
    this.cells[4].textContent = status.missed;
    this.cells[5].textContent = number(now.cpu, 1);
    this.cells[6].textContent = number(status.rss / 1e6, 1);
    this.cells[7].classList.toggle("degraded", status.degraded);
    this.cells[7].textContent = (status.degraded ? "degraded: " : "") + status.note;
  }
}

export class Timeline {
  constructor(body) {
    this.body = body;
    this.rows = new Map(); // component: Row
  }

  take(statuses) {
    for (const status of statuses) {
      if (!this.rows.has(status.component))
        this.rows.set(status.component, new Row(this.body, status.component));
      const row = this.rows.get(status.component);
      const isNew = row.status?.utime !== status.utime || row.status?.boot !== status.boot;
      if (isNew) row.take(status);
    }
  }

  // By the page's own clock: a replayed STATUS has the time when it was recorded.
  markSilent(now) {
    for (const row of this.rows.values()) row.row.classList.toggle("silent", now - row.heard > SILENT);
  }
}
