"use strict";
const at = id => document.getElementById(id);
const time = s => s === null ? "?" : s < 90 ? s.toFixed(s < 10 ? 1 : 0) + " s" : s < 5400 ? (s / 60).toFixed(0) + " min" : (s / 3600).toFixed(1) + " h";
const short = n => n < 1e4 ? n.toFixed(n < 100 && n % 1 ? 2 : 0) : n < 1e6 ? (n / 1e3).toFixed(0) + " thousand" : n < 1e9 ? (n / 1e6).toFixed(1) + " million" : (n / 1e9).toFixed(2) + " billion";
// What is known of a render in one process, in this order, as far as it is known.
const FACTS = [
  ["size", s => s.width === undefined ? undefined : s.width + " \u00d7 " + s.height],
  ["method", s => s.method],
  ["samples per pixel", s => s.samplesPerPixel === undefined ? undefined : short(s.samplesPerPixel) + (s.decidedBy ? ", decided by " + s.decidedBy : "")],
  ["samples so far", s => s.samples === undefined ? undefined : short(s.samples) + ", " + short(s.samplesPerSecond) + " a second"],
  ["rays", s => s.rays === undefined ? undefined : short(s.rays) + ", " + short(s.raysPerSecond) + " a second"],
  ["estimated error", s => s.estimatedError === undefined || s.estimatedError === null ? undefined : s.estimatedError.toPrecision(2)],
  ["threads", s => s.threads],
  ["processor time", s => s.processorSeconds === undefined ? undefined : time(s.processorSeconds)],
  ["memory", s => s.memoryBytes === undefined ? undefined : (s.memoryBytes / 1e6).toFixed(0) + " MB"],
];
// The render waits with its end until those that look have seen it: it knows them by this.
const page = Math.random().toString(36).slice(2);
const isOver = s => s.state === "finished" || s.state === "stopped";

function words(s) {
  const times = time(s.elapsedSeconds) + " so far" + (isOver(s) ? "" : ", " + time(s.remainingSeconds) + " to go");
  if (s.workers === undefined) {
    return s.state === "preparing" ? "The picture is being prepared; " + times
      : s.done + " of " + s.total + " " + s.unit + " done; " + (isOver(s) ? time(s.elapsedSeconds) + " in all" : times);
  }
  return s.done + " of " + s.total + " " + s.unit + " done, " + s.leased + " in work, " + s.free + " waiting; "
    + time(s.elapsedSeconds) + " so far, " + time(s.remainingSeconds) + " to go; "
    + s.confirmed + " confirmed by a second machine, " + s.auditsOpen + " to be confirmed"
    + (s.expelled.length ? "; expelled: " + s.expelled.join(", ") : "");
}

function row(cells, name) {
  const row = document.createElement("tr");
  row.className = name;
  for (const cell of cells) {
    row.appendChild(document.createElement("td")).textContent = cell;
  }
  return row;
}

function show(s) {
  const percent = n => s.total ? 100 * n / s.total : 0;
  const state = isOver(s) ? s.state : s.state === "preparing" ? "" : Math.floor(percent(s.done)) + " %";
  at("title").textContent = s.title || "Enlightenment";
  at("state").textContent = state;
  document.title = [state, s.title || "Enlightenment"].filter(part => part).join(" \u2013 ");
  at("done").style.width = percent(s.done) + "%";
  at("leased").style.left = percent(s.done) + "%";
  at("leased").style.width = percent(s.leased || 0) + "%";
  at("bar").setAttribute("aria-valuenow", Math.floor(percent(s.done)));
  at("numbers").textContent = words(s);
  const facts = s.workers ? [] : FACTS.map(([name, of]) => [name, of(s)]).filter(fact => fact[1] !== undefined);
  at("statistics").hidden = !facts.length;
  at("facts").replaceChildren(...facts.map(fact => row(fact, "")));
  at("farm").hidden = !s.workers;
  at("workers").replaceChildren(...(s.workers || []).map(w => row([w.name, w.threads, w.tiles,
    w.tilesPerSecond === null ? "?" : w.tilesPerSecond.toFixed(2), w.owed, (w.bytes / 1e6).toFixed(1),
    time(w.connectedSeconds), time(w.silentSeconds)], w.stalled ? "stalled" : "")));
  at("notes").hidden = !s.log.length;
  at("log").textContent = s.log.map(n => time(n.seconds).padStart(8) + "  " + n.text).reverse().join("\n");
}

// Small pictures are shown larger, their pixels as squares.
at("picture").addEventListener("load", () => {
  const picture = at("picture");
  const times = Math.min(Math.floor(at("view").clientWidth / picture.naturalWidth), Math.floor(480 / picture.naturalHeight));
  picture.className = times > 1 ? "pixels" : "";
  picture.style.width = times > 1 ? times * picture.naturalWidth + "px" : "";
  picture.hidden = false;
});

let shown = "";
// What did not come, the last picture above all, is asked for again.
at("picture").addEventListener("error", () => shown = "");
let last = null;
async function update() {
  try {
    const s = await (await fetch("status.json?page=" + page)).json();
    last = s;
    show(s);
    at("problem").textContent = "";
    const picture = s.picture + "&state=" + s.state;
    if (s.picture && picture !== shown) {
      shown = picture;
      at("picture").src = "picture.png?page=" + page + "&n=" + picture;
    }
  } catch (e) {
    // Whoever has seen the end need not be told that there is nobody any more.
    at("problem").textContent = last && isOver(last) ? "" : "There is no answer: the render has ended, or was stopped.";
  }
  setTimeout(update, 1000);
}
update();
