// Rows of the run as they come: kept for a while, drawn as strip charts, and given to the scene.
const KEPT = 1500; // messages, about 50 s of them
const LEAST = 60, MOST = 500, SHARE = 4; // ms between two drawings of the charts, and times what one takes
const COLOURS = ["#2f7ebc", "#c77d0a", "#2a9d64", "#b3487f", "#7a5bc4", "#5f7d8c"];

export const rig = { signals: [], frames: [], charts: [], window: 20, received: 0, drawn: 0, time: 0, listeners: [], about: null };
window.rig = rig;

function connect() {
  const way = location.protocol === "https:" ? "wss:" : "ws:";
  const socket = new WebSocket(`${way}//${location.host}/rows`);
  socket.binaryType = "arraybuffer";
  socket.onmessage = (event) => {
    if (typeof event.data === "string") {
      const told = JSON.parse(event.data);
      rig.frames = [];
      if (told.signals) {
        const first = rig.about === null;
        rig.about = told;
        rig.signals = told.signals;
        if (first) {
          told.charts.forEach((numbers) => rig.chart(numbers));
          rig.listeners.forEach((listener) => listener.about?.(told));
        }
      }
      rig.listeners.forEach((listener) => listener.begins?.());
      return;
    }
    const n = rig.signals.length;
    const frame = { t: new DataView(event.data).getFloat64(4, true), v: new Float32Array(event.data, 12, 3 * n) };
    if (rig.frames.length && frame.t < rig.frames.at(-1).t) rig.frames = [];
    rig.frames.push(frame);
    if (rig.frames.length > KEPT) rig.frames.shift();
    rig.time = frame.t;
    rig.received += 1;
    rig.listeners.forEach((listener) => listener.rows?.(frame));
    socket.send("a");
  };
  socket.onopen = () => document.body.classList.remove("cut");
  socket.onclose = () => {
    document.body.classList.add("cut");
    setTimeout(connect, 1000);
  };
}

rig.number = (name) => rig.signals.findIndex((signal) => signal.name === name);

rig.chart = (numbers) => {
  const place = document.getElementById("charts");
  const box = document.createElement("div");
  box.className = "box chart";
  box.innerHTML = '<button class="shut" title="remove this chart" aria-label="remove this chart">&times;</button>';
  const legend = document.createElement("div");
  legend.className = "legend";
  const values = numbers.map((number, k) => {
    const entry = document.createElement("span"), mark = document.createElement("i"), value = document.createElement("b");
    const { name, unit, description } = rig.signals[number];
    mark.style.background = COLOURS[k % COLOURS.length];
    entry.title = description || "";
    entry.append(mark, `${name}${unit && unit !== "1" ? ` [${unit}]` : ""} `, value);
    legend.append(entry);
    return value;
  });
  const canvas = document.createElement("canvas");
  box.append(legend, canvas);
  place.append(box);
  const chart = { numbers, canvas, values, box };
  box.firstChild.onclick = () => {
    rig.charts = rig.charts.filter((other) => other !== chart);
    box.remove();
  };
  rig.charts.push(chart);
};

rig.add = (names) => {
  const numbers = names.map(rig.number).filter((number) => number >= 0);
  if (numbers.length) rig.chart(numbers);
};

const shown = (value) => (Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3) ? value.toExponential(2) : value.toPrecision(4));

function ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= raw) || raw;
  const found = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

function draw(chart, frames, begin, end) {
  const { canvas, numbers } = chart, n = rig.signals.length;
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (!width) return;
  if (canvas.width !== Math.round(width * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, width, height);
  let low = Infinity, high = -Infinity;
  for (const { v } of frames)
    for (const k of numbers) {
      if (v[n + k] < low) low = v[n + k];
      if (v[2 * n + k] > high) high = v[2 * n + k];
    }
  if (!(low <= high)) return;
  const margin = Math.max(0.06 * (high - low), 1e-9, 1e-6 * Math.abs(high));
  low -= margin;
  high += margin;
  const left = 52, bottom = 16, ink = getComputedStyle(canvas).color;
  const x = (t) => left + ((t - begin) / (end - begin)) * (width - left - 4);
  const y = (value) => height - bottom - ((value - low) / (high - low)) * (height - bottom - 4);
  pen.font = "10px sans-serif";
  pen.fillStyle = pen.strokeStyle = ink;
  pen.lineWidth = 1;
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const value of ticks(low, high, 4)) {
    pen.globalAlpha = 0.15;
    pen.beginPath();
    pen.moveTo(left, y(value));
    pen.lineTo(width, y(value));
    pen.stroke();
    pen.globalAlpha = 0.8;
    pen.fillText(Math.abs(value) < 1e-12 * (high - low) ? "0" : Number(value.toPrecision(6)).toString(), left - 5, y(value));
  }
  pen.textAlign = "center";
  pen.textBaseline = "bottom";
  for (const t of ticks(begin, end, Math.max(width / 90, 2))) pen.fillText(`${Number(t.toPrecision(6))} s`, Math.min(x(t), width - 16), height - 1);
  numbers.forEach((k, at) => {
    pen.strokeStyle = pen.fillStyle = COLOURS[at % COLOURS.length];
    pen.globalAlpha = 0.25;
    pen.beginPath();
    frames.forEach(({ t, v }, i) => (i ? pen.lineTo(x(t), y(v[2 * n + k])) : pen.moveTo(x(t), y(v[2 * n + k]))));
    for (let i = frames.length - 1; i >= 0; i--) pen.lineTo(x(frames[i].t), y(frames[i].v[n + k]));
    pen.fill();
    pen.globalAlpha = 1;
    pen.lineWidth = 1.4;
    pen.beginPath();
    frames.forEach(({ t, v }, i) => (i ? pen.lineTo(x(t), y(v[k])) : pen.moveTo(x(t), y(v[k]))));
    pen.stroke();
    chart.values[at].textContent = shown(frames.at(-1).v[k]);
  });
}

let last = 0, pause = LEAST, seen = 0;
function loop(now) {
  requestAnimationFrame(loop);
  if (now - last < (rig.received === seen ? MOST : pause) || !rig.frames.length || document.hidden) return;
  last = now;
  seen = rig.received;
  const begun = performance.now();
  const end = Math.max(rig.frames.at(-1).t, rig.frames[0].t + 1e-3), begin = Math.max(end - rig.window, rig.frames[0].t);
  const first = rig.frames.findIndex((frame) => frame.t >= begin), frames = rig.frames.slice(Math.max(first, 0));
  rig.charts.forEach((chart) => draw(chart, frames, begin, Math.max(end, begin + 1e-3)));
  const clock = document.getElementById("clock");
  if (clock) clock.textContent = `${rig.time.toFixed(3)} s`;
  rig.drawn += 1;
  pause = Math.min(Math.max(LEAST, SHARE * (performance.now() - begun)), MOST);
}

function begin() {
  if (!document.getElementById("charts")) return setTimeout(begin, 50);
  connect();
  requestAnimationFrame(loop);
}
begin();
