// The picture that was kept, "A", beside the picture of now: a divider that mouse, fingers and keys move.
const at = id => document.getElementById(id);
const KEY_STEP = 0.02;

let url = null;
let place = 0.5;
let number = 0;
let hasAsked = false;

const isSplit = () => number > 0 && at("split").checked && at("layer").value !== "difference";

/** Puts A and the divider where the picture is. */
export function arrange() {
  const isShown = isSplit() && !at("picture").hidden;
  for (const id of ["kept", "divider", "nameA", "nameB"]) {
    at(id).hidden = !isShown;
  }
  if (!isShown) {
    return;
  }
  const { offsetLeft: left, offsetTop: top, offsetWidth: width, offsetHeight: height } = at("picture");
  const put = (id, values) => Object.entries(values).forEach(([k, v]) => {
    at(id).style[k] = v + "px";
  });
  put("kept", { left, top, width, height });
  at("kept").style.clipPath = "inset(0 " + (1 - place) * 100 + "% 0 0)";
  put("divider", { left: left + place * width, top, height });
  put("nameA", { left: left + 6, top: top + 6 });
  at("nameB").style.right = at("stage").clientWidth - left - width + 6 + "px";
  at("nameB").style.top = top + 6 + "px";
  const percent = Math.round(place * 100);
  at("divider").setAttribute("aria-valuenow", percent);
  at("divider").setAttribute("aria-valuetext", percent + " % A");
}

function move(to) {
  place = Math.min(Math.max(to, 0), 1);
  arrange();
}

/** Shows what the state says is kept. */
export function update(s) {
  if (s.kept !== number) {
    number = s.kept;
    if (number) {
      at("kept").src = url("kept.png", { n: number });
      at("split").checked = at("split").checked || hasAsked;
    }
    hasAsked = false;
  }
  at("comparing").hidden = !number;
  at("forget").disabled = !number;
  at("keep").disabled = !s.picture;
  at("keptText").textContent = number ? "A: " + s.keptSamples + (s.keptSamples === 1 ? " sample" : " samples") + " per pixel" : "";
  arrange();
}

function dragged() {
  const divider = at("divider");
  divider.addEventListener("pointerdown", event => {
    // The picture behind it is not to be turned.
    event.stopPropagation();
    divider.setPointerCapture(event.pointerId);
  });
  divider.addEventListener("pointermove", event => {
    event.stopPropagation();
    if (divider.hasPointerCapture(event.pointerId)) {
      const box = at("picture").getBoundingClientRect();
      move((event.clientX - box.left) / box.width);
    }
  });
}

const STEPS = { ArrowLeft: -KEY_STEP, ArrowDown: -KEY_STEP, ArrowRight: KEY_STEP, ArrowUp: KEY_STEP, PageDown: -0.2, PageUp: 0.2 };

function keyed(event) {
  const to = STEPS[event.key] ? place + STEPS[event.key] : event.key === "Home" ? 0 : event.key === "End" ? 1 : null;
  if (to !== null) {
    move(to);
    event.preventDefault();
    event.stopPropagation();
  }
}

/**
 * Begins to listen.
 * @param addressOf makes an address with the key of a path and parameters
 * @param send takes actions
 */
export function start(addressOf, send) {
  url = addressOf;
  const keep = () => {
    hasAsked = true;
    send({ action: "keep" });
  };
  at("keep").addEventListener("click", keep);
  at("forget").addEventListener("click", () => send({ action: "forget" }));
  at("split").addEventListener("change", arrange);
  at("layer").addEventListener("change", arrange);
  at("divider").addEventListener("keydown", keyed);
  dragged();
  at("stage").addEventListener("keydown", event => {
    if (event.target !== at("stage") || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    if (event.key === "a") {
      keep();
    } else if (event.key === "s" && number) {
      at("split").checked = !at("split").checked;
      arrange();
    } else if ((event.key === "<" || event.key === ">") && isSplit()) {
      move(place + (event.key === "<" ? -KEY_STEP : KEY_STEP));
    } else {
      return;
    }
    event.preventDefault();
  });
  new ResizeObserver(arrange).observe(at("picture"));
  new ResizeObserver(arrange).observe(at("stage"));
}
