import { film } from "./film.js";
import { listen, motion, sum } from "./pointer.js";
import * as layers from "./layers.js";
import * as compare from "./compare.js";
import * as convergence from "./convergence.js";

const at = id => document.getElementById(id);
// The key stands behind "#" of the address, which browsers keep to themselves.
const key = location.hash.slice(1);
const sleep = millis => new Promise(done => setTimeout(done, millis));
const url = (path, parameters) => path + "?" + new URLSearchParams({ key, ...parameters });

let state = null;
let shown = 0;
let chosen = null;

function say(text) {
  at("note").textContent = text;
}

async function act(action) {
  const { action: name, x, y } = action;
  const numbers = Object.fromEntries(Object.entries({ x, y }).filter(([, v]) => v !== undefined).map(([k, v]) => [k, String(v)]));
  const answer = await fetch(url("do", { action: name, ...numbers }), { method: "POST" });
  if (!answer.ok) {
    say((await answer.text()).trim());
  }
}

// While a request is under way, further motions of a kind become one.
const pending = new Map();
let isSending = false;
async function send(action) {
  const before = pending.get(action.action);
  pending.set(action.action, before && action.x !== undefined && !action.replaces ? sum(before, action) : action);
  if (isSending) {
    return;
  }
  isSending = true;
  try {
    while (pending.size) {
      const [name, next] = pending.entries().next().value;
      pending.delete(name);
      await act(next);
    }
  } catch (e) {
    pending.clear();
    say("There is no answer.");
  } finally {
    isSending = false;
  }
}

function fit() {
  if (!state || !state.width) {
    return;
  }
  const stage = at("stage");
  // On a phone the stage is no higher than the picture needs.
  stage.style.setProperty("--shape", state.height / state.width);
  const scale = Math.min(stage.clientWidth / state.width, stage.clientHeight / state.height);
  at("picture").style.width = Math.round(state.width * scale) + "px";
  at("picture").style.height = Math.round(state.height * scale) + "px";
}

function progress(s) {
  if (!s.picture) {
    return "The first picture is being rendered.";
  }
  const size = s.width + " × " + s.height;
  return s.shrink > 1 ? size + ", coarse 1/" + s.shrink
    : size + ", " + s.samples + (s.samples === 1 ? " sample" : " samples") + " per pixel" + (s.finished ? ", finished" : "");
}

function slide(input, output, value, unit) {
  if (document.activeElement !== input || !pending.size && !isSending) {
    input.value = value;
  }
  output.textContent = Number(value.toPrecision(4)) + unit;
}

function show(s) {
  state = s;
  at("title").textContent = s.title;
  document.title = s.title + " – view";
  at("progress").textContent = progress(s);
  at("problem").hidden = !s.problems.length;
  const problems = s.problems.join("\n");
  if (at("problem").textContent !== problems) {
    at("problem").textContent = problems;
  }
  at("angle").hidden = s.fieldOfView === null;
  if (s.fieldOfView !== null) {
    slide(at("fieldOfView"), at("degrees"), s.fieldOfView, "°");
  }
  at("light").hidden = s.exposure === null;
  if (s.exposure !== null) {
    slide(at("exposure"), at("stops"), s.exposure, s.exposure === 1 ? " stop" : " stops");
  }
  at("focus").hidden = !s.focuses;
  at("aim").hidden = !s.turns;
  at("save").disabled = Boolean(s.refusal) || !s.moved;
  at("save").title = s.refusal;
  at("reset").disabled = !s.moved;
  if (s.note) {
    say(s.note);
  }
  frames(s);
  layers.update(s);
  if (s.picture && s.picture !== shown) {
    shown = s.picture;
    load(s.picture);
  }
  fit();
  compare.update(s);
  convergence.update(s);
}

// Pictures are put in place when they are whole, and not before older ones.
let newest = 0;
function load(number) {
  const wanted = layers.current();
  const next = new Image();
  next.onload = () => {
    if (number >= newest && wanted === layers.current()) {
      newest = number;
      at("picture").src = next.src;
      at("picture").hidden = false;
      compare.arrange();
    }
  };
  // There may be no other picture that would come instead.
  next.onerror = () => setTimeout(() => number === shown && load(number), 1000);
  next.src = layers.address(number);
}

async function watch() {
  for (let version = 0; ;) {
    try {
      const answer = await fetch(url("state.json", { after: version, ...layers.query() }));
      if (answer.status === 403) {
        say("The key is missing or wrong: open the address that the command printed.");
        return;
      }
      if (!answer.ok) {
        say((await answer.text()).trim());
        await sleep(1000);
        continue;
      }
      const s = await answer.json();
      version = s.version;
      show(s);
    } catch (e) {
      at("progress").textContent = "There is no answer: the command has ended.";
      version = 0;
      await sleep(1000);
    }
  }
}

async function pick(x, y) {
  chosen = { x, y };
  layers.read(x, y);
  const answer = await fetch(url("pixel.json", chosen));
  if (!answer.ok) {
    say((await answer.text()).trim());
    return;
  }
  const p = await answer.json();
  const vector = v => v.map(c => Number(c.toPrecision(6))).join(", ");
  const facts = [["object", p.object], ["material", p.material], ["point", p.point && vector(p.point)],
    ["normal", p.normal && vector(p.normal)], ["depth", p.depth && Number(p.depth.toPrecision(6))],
    [p.unit === "linear" ? "radiance" : "colour", p.value && vector(p.value)],
    ["standard error", p.error && "\u00b1 " + p.error.map(c => Number(c.toPrecision(2))).join(", ")], ["samples", p.samples]];
  at("facts").replaceChildren(...facts.filter(f => f[1] !== undefined).flatMap(([name, value]) => {
    const term = document.createElement("dt");
    term.textContent = name;
    const text = document.createElement("dd");
    text.textContent = value;
    return [term, text];
  }));
  at("pixel").hidden = false;
}

async function copy() {
  const text = await (await fetch(url("camera.json"))).text();
  at("camera").textContent = text;
  at("camera").hidden = false;
  try {
    await navigator.clipboard.writeText(text);
    say("The camera is in the clipboard.");
  } catch (e) {
    say("The camera, to be copied by hand:");
  }
}

const mode = () => document.querySelector("input[name=mode]:checked").value;
listen(at("stage"), at("picture"), mode, send, pick);
const frames = film(at("stage"), send);
at("steps").addEventListener("click", event => {
  const { x, y } = event.target.dataset;
  if (x !== undefined) {
    send(motion(mode(), Number(x) * 0.05, Number(y) * 0.05));
  }
});
at("fieldOfView").addEventListener("input", e => send({ action: "field-of-view", x: Number(e.target.value), replaces: true }));
at("exposure").addEventListener("input", e => send({ action: "exposure", x: Number(e.target.value), replaces: true }));
at("reset").addEventListener("click", () => send({ action: "reset" }));
at("save").addEventListener("click", () => send({ action: "save" }));
at("copy").addEventListener("click", copy);
at("aim").addEventListener("click", () => chosen && send({ action: "aim", ...chosen, replaces: true }));
at("focus").addEventListener("click", () => chosen && send({ action: "focus", ...chosen, replaces: true }));

layers.start(url, () => state && state.picture && load(state.picture));
compare.start(url, send);
convergence.start(url);

let resized = 0;
new ResizeObserver(() => {
  fit();
  clearTimeout(resized);
  resized = setTimeout(() => send({ action: "size", x: at("stage").clientWidth, y: at("stage").clientHeight, replaces: true }), 150);
}).observe(at("stage"));
watch();
