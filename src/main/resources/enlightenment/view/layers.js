// What is shown of each pixel: the menu, its keys, the scale, the legend, and what is under the pointer.
const at = id => document.getElementById(id);
const DIGITS = 4;

let url = null;
let changed = null;
let state = null;
let described = "";
let isDescribing = false;
let isReading = false;
let nextPlace = null;
let lastPlace = null;

/** The layer that is chosen, as requests name it. */
export function current() {
  return at("layer").value;
}

/** What requests for the state say of it, so that renders make it. */
export function query() {
  return current() === "picture" ? {} : { layer: current() };
}

/** Where the picture of the layer is; while that is not there, the picture itself. */
export function address(number) {
  const layer = current();
  return isThere(layer) && layer !== "picture" ? url("layer.png", { layer, n: number }) : url("picture.png", { n: number });
}

const isThere = layer => Boolean(state) && state.layers.includes(layer);

const REASONS = {
  picture: "",
  denoised: "Grain is removed from the second pass at full resolution on.",
  error: "The error is known from the second pass at full resolution on.",
  difference: "Pictures of one size are compared: the picture of now is smaller or larger than A.",
};

function choose(layer) {
  const option = [...at("layer").options].find(o => o.value === layer);
  if (option && !option.disabled && layer !== current()) {
    at("layer").value = layer;
    switched();
  }
}

function switched() {
  described = "";
  lastPlace = null;
  at("reading").textContent = "";
  at("picture").classList.toggle("flat", ["object", "material"].includes(current()));
  clear("");
  // The request says what is looked at: it is rendered from then on.
  fetch(url("state.json", { after: 0, ...query() })).catch(() => {});
  changed();
  describe();
}

function clear(text) {
  at("meaning").textContent = text;
  at("scale").hidden = true;
  at("legend").replaceChildren();
}

/** Brings scale and legend up to date with the state. */
export function update(s) {
  state = s;
  const option = name => [...at("layer").options].find(o => o.value === name);
  option("albedo").disabled = !s.albedo;
  option("denoised").disabled = !s.albedo;
  option("difference").disabled = !s.kept;
  if (at("layer").selectedOptions[0].disabled) {
    choose("picture");
  }
  describe();
}

async function describe() {
  const wanted = current() + " " + (state ? state.picture + " " + state.kept : "");
  if (isDescribing || described === wanted || !state) {
    return;
  }
  if (!isThere(current()) || current() === "picture") {
    clear(REASONS[current()] ?? "It is being rendered.");
    return;
  }
  isDescribing = true;
  try {
    const layer = current();
    const answer = await fetch(url("layer.json", { layer }));
    if (layer === current()) {
      described = wanted;
      if (answer.ok) {
        explain(await answer.json());
      } else {
        clear((await answer.text()).trim());
      }
    }
  } catch (e) {
    described = "";
    return;
  } finally {
    isDescribing = false;
  }
  describe();
}

const short = v => String(Number(v.toPrecision(DIGITS)));

function figures(d) {
  if (d.rmse === undefined) {
    return "";
  }
  const noise = d.noise === undefined ? "" : "; the noise of both accounts for about " + short(d.noise);
  return ". RMSE " + short(d.rmse) + noise;
}

function explain(d) {
  at("meaning").textContent = d.explanation + figures(d) + ".";
  at("scale").hidden = !d.marks.length;
  at("bar").className = d.layer === "depth" ? "greys" : "magma";
  at("marks").replaceChildren(...d.marks.map(mark => {
    const item = document.createElement("li");
    item.textContent = short(Number(mark));
    return item;
  }));
  const entries = d.legend.map(entry => {
    const item = document.createElement("li");
    const swatch = document.createElement("span");
    swatch.className = "swatch";
    swatch.style.backgroundColor = entry.color;
    const name = document.createElement("span");
    name.textContent = entry.name;
    const share = document.createElement("span");
    share.className = "share";
    share.textContent = (entry.share * 100).toFixed(entry.share < 0.1 ? 1 : 0) + " %";
    item.append(swatch, name, share);
    item.dataset.name = entry.name;
    return item;
  });
  if (d.more) {
    const item = document.createElement("li");
    item.textContent = "and " + d.more + " more";
    entries.push(item);
  }
  at("legend").replaceChildren(...entries);
  // What is under a pointer that rests may be another thing now.
  if (lastPlace) {
    read(lastPlace.x, lastPlace.y);
  }
}

/** Shows what a layer is at a place, 0..1 from the left and from the top. One request at a time: the last place counts. */
export async function read(x, y) {
  if (current() === "picture" || !isThere(current())) {
    return;
  }
  nextPlace = { x, y };
  lastPlace = nextPlace;
  if (isReading) {
    return;
  }
  isReading = true;
  try {
    while (nextPlace) {
      const place = nextPlace;
      nextPlace = null;
      const layer = current();
      const answer = await fetch(url("value.json", { layer, ...place }));
      if (answer.ok && layer === current()) {
        tell(layer, await answer.json());
      }
    }
  } catch (e) {
    nextPlace = null;
  } finally {
    isReading = false;
  }
}

function tell(layer, value) {
  const text = value.name !== undefined ? value.name : value.values.length ? value.values.map(short).join(", ") : "nothing";
  at("reading").textContent = layer + ": " + text;
  for (const item of at("legend").children) {
    item.classList.toggle("here", item.dataset.name === value.name);
  }
}

/**
 * Begins to listen.
 * @param addressOf makes an address with the key of a path and parameters
 * @param onChange is called when another layer was chosen
 */
export function start(addressOf, onChange) {
  url = addressOf;
  changed = onChange;
  at("layer").addEventListener("change", switched);
  at("stage").addEventListener("pointermove", event => {
    const box = at("picture").getBoundingClientRect();
    const place = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    if (event.pointerType === "mouse" && !event.buttons && place.every(c => c >= 0 && c <= 1)) {
      read(...place);
    }
  });
  at("stage").addEventListener("keydown", event => {
    const numbered = /^[1-9]$/.test(event.key) ? at("layer").options[event.key - 1].value : "";
    const layer = event.key.toLowerCase() === "g" ? "denoised" : numbered;
    if (layer && !event.ctrlKey && !event.metaKey && !event.altKey) {
      choose(layer);
      event.preventDefault();
    }
  });
}
