// How the estimated error of the picture falls with time, both logarithmic.
const at = id => document.getElementById(id);
const NAMESPACE = "http://www.w3.org/2000/svg";
const WIDTH = 260;
const HEIGHT = 170;
const LEFT = 46;
const RIGHT = 8;
const TOP = 8;
const BOTTOM = 32;
// How far beyond the last point the dashed line goes, as a factor of time.
const BEYOND = 4;

let url = null;
let shown = "";
let wanted = "";
let isAsking = false;

function element(name, attributes, text) {
  const made = document.createElementNS(NAMESPACE, name);
  Object.entries(attributes).forEach(([k, v]) => made.setAttribute(k, v));
  if (text !== undefined) {
    made.textContent = text;
  }
  return made;
}

/** An axis from one number to another, both greater than 0, onto pixels. */
function axis(from, to, start, end) {
  const low = Math.log10(from);
  const high = Math.log10(to);
  return v => start + (Math.log10(v) - low) / (high - low) * (end - start);
}

/** 1, 2 and 5 times powers of ten within a range; powers alone where these are many. */
function ticks(from, to) {
  const all = [];
  const isWide = Math.log10(to / from) > 1.6;
  for (let e = Math.floor(Math.log10(from)); e <= Math.log10(to); e++) {
    for (const digit of isWide ? [1] : [1, 2, 5]) {
      const tick = Number(digit + "e" + e);
      if (tick >= from * 0.999 && tick <= to * 1.001) {
        all.push(tick);
      }
    }
  }
  return all;
}

const short = v => String(Number(v.toPrecision(3)));

function draw(points) {
  const times = points.map(p => p.seconds);
  const errors = points.map(p => p.error);
  const last = points[points.length - 1];
  const expected = last.error / Math.sqrt(BEYOND);
  const x0 = Math.min(...times) / 1.2;
  const x1 = Math.max(...times) * BEYOND;
  const y0 = Math.min(...errors, expected) / 1.2;
  const y1 = Math.max(...errors) * 1.2;
  const x = axis(x0, x1, LEFT, WIDTH - RIGHT);
  const y = axis(y0, y1, HEIGHT - BOTTOM, TOP);
  const parts = [];
  for (const t of ticks(x0, x1)) {
    parts.push(element("line", { class: "grid", x1: x(t), x2: x(t), y1: TOP, y2: HEIGHT - BOTTOM }));
    parts.push(element("text", { x: x(t), y: HEIGHT - BOTTOM + 13, "text-anchor": "middle" }, short(t)));
  }
  for (const t of ticks(y0, y1)) {
    parts.push(element("line", { class: "grid", x1: LEFT, x2: WIDTH - RIGHT, y1: y(t), y2: y(t) }));
    parts.push(element("text", { x: LEFT - 4, y: y(t) + 4, "text-anchor": "end" }, short(t)));
  }
  parts.push(element("text", { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 4, "text-anchor": "middle" }, "seconds"));
  parts.push(element("line", { class: "expected", x1: x(last.seconds), y1: y(last.error), x2: x(x1), y2: y(expected) }));
  parts.push(element("polyline", { class: "measured", points: points.map(p => x(p.seconds) + "," + y(p.error)).join(" ") }));
  parts.push(...points.map(p => element("circle", { class: "point", cx: x(p.seconds), cy: y(p.error), r: points.length > 40 ? 1.5 : 2.5 })));
  const text = "RMSE " + short(last.error) + " after " + short(last.seconds) + " s, " + last.samples + " samples per pixel";
  at("curve").replaceChildren(...parts);
  at("curve").setAttribute("aria-label", "Estimated error by time, both logarithmic: " + text);
  at("curveText").textContent = text + ", estimated. Dashed: the square root law from here on, not measured.";
}

async function ask() {
  if (isAsking || shown === wanted || !at("accuracy").open) {
    return;
  }
  isAsking = true;
  const asked = wanted;
  try {
    const answer = await fetch(url("convergence.json", {}));
    const points = answer.ok ? (await answer.json()).points.filter(p => p.error > 0) : [];
    at("curve").toggleAttribute("hidden", !points.length);
    if (points.length) {
      draw(points);
    } else {
      at("curveText").textContent = "The error is known from the second pass at full resolution on.";
    }
    shown = asked;
  } catch (e) {
    return;
  } finally {
    isAsking = false;
  }
  ask();
}

/** Brings the curve up to date with the state. */
export function update(s) {
  wanted = String(s.picture);
  ask();
}

/** @param addressOf makes an address with the key of a path and parameters */
export function start(addressOf) {
  url = addressOf;
  at("accuracy").addEventListener("toggle", ask);
}
