// Mouse, fingers and keys, as motions of the camera. Lengths are in heights of the picture, angles in degrees.
const DEGREES_PER_HEIGHT = 180;
const ZOOM_PER_HEIGHT = 2;
const WHEEL_PIXELS = 600;
const CLICK_PIXELS = 4;
const KEY_STEP = 0.05;

/** A motion by a step of the pointer, to the right and downwards. */
export function motion(mode, x, y) {
  switch (mode) {
    case "orbit": return { action: "orbit", x: -x * DEGREES_PER_HEIGHT, y: y * DEGREES_PER_HEIGHT };
    case "pan": return { action: "pan", x, y };
    case "dolly": return { action: "dolly", x: Math.exp(y * ZOOM_PER_HEIGHT) };
    default: return { action: "roll", x: x * DEGREES_PER_HEIGHT };
  }
}

/** What two motions of one kind come to together. */
export function sum(a, b) {
  return a.action === "dolly" ? { action: "dolly", x: a.x * b.x }
    : { action: a.action, x: a.x + b.x, y: a.y === undefined ? undefined : a.y + b.y };
}

const KEYS = {
  ArrowLeft: [-KEY_STEP, 0], ArrowRight: [KEY_STEP, 0], ArrowUp: [0, -KEY_STEP], ArrowDown: [0, KEY_STEP],
};

function ofKey(event) {
  if (KEYS[event.key]) {
    return motion(event.shiftKey ? "pan" : "orbit", ...KEYS[event.key]);
  }
  switch (event.key) {
    case "+": case "=": return motion("dolly", 0, -KEY_STEP);
    case "-": return motion("dolly", 0, KEY_STEP);
    case "[": return motion("roll", -KEY_STEP, 0);
    case "]": return motion("roll", KEY_STEP, 0);
    case "0": return { action: "reset" };
    default: return null;
  }
}

/**
 * Listens to an element.
 * @param picture the image, for its size and place
 * @param mode returns what dragging does
 * @param move takes motions
 * @param pick takes a place in the picture, 0..1 from the left and from the top
 */
export function listen(stage, picture, mode, move, pick) {
  const pointers = new Map();
  let travelled = 0;

  function pickAt(x, y) {
    const box = picture.getBoundingClientRect();
    const place = [(x - box.left) / box.width, (y - box.top) / box.height];
    if (place.every(c => c >= 0 && c <= 1)) {
      pick(...place);
    }
  }

  function drag(event, dx, dy) {
    const height = picture.clientHeight || stage.clientHeight;
    const chosen = event.shiftKey || event.buttons & 6 ? "pan" : event.ctrlKey ? "roll" : mode();
    move(motion(chosen, dx / height, dy / height));
  }

  function pinch(before, after) {
    const height = picture.clientHeight || stage.clientHeight;
    const span = ([a, b]) => [b.x - a.x, b.y - a.y];
    const [bx, by] = span(before);
    const [ax, ay] = span(after);
    const ratio = Math.hypot(bx, by) / Math.max(Math.hypot(ax, ay), 1);
    move({ action: "dolly", x: Math.min(Math.max(ratio, 0.5), 2) });
    let turn = (Math.atan2(ay, ax) - Math.atan2(by, bx)) * 180 / Math.PI;
    turn = turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn;
    move({ action: "roll", x: turn });
    const middle = ([a, b], c) => (a[c] + b[c]) / 2;
    move(motion("pan", (middle(after, "x") - middle(before, "x")) / height, (middle(after, "y") - middle(before, "y")) / height));
  }

  stage.addEventListener("pointerdown", event => {
    if (event.target.closest("#problem")) {
      return;
    }
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    travelled = pointers.size > 1 ? Infinity : 0;
  });
  stage.addEventListener("pointermove", event => {
    const last = pointers.get(event.pointerId);
    if (!last) {
      return;
    }
    const now = { x: event.clientX, y: event.clientY };
    travelled += Math.hypot(now.x - last.x, now.y - last.y);
    if (pointers.size === 2) {
      const before = [...pointers.values()];
      pointers.set(event.pointerId, now);
      pinch(before, [...pointers.values()]);
    } else if (travelled >= CLICK_PIXELS) {
      drag(event, now.x - last.x, now.y - last.y);
      pointers.set(event.pointerId, now);
    }
  });
  const up = event => {
    const was = pointers.delete(event.pointerId);
    if (was && event.type === "pointerup" && event.button === 0 && travelled < CLICK_PIXELS) {
      pickAt(event.clientX, event.clientY);
    }
  };
  stage.addEventListener("pointerup", up);
  stage.addEventListener("pointercancel", up);
  stage.addEventListener("contextmenu", event => event.preventDefault());
  stage.addEventListener("wheel", event => {
    event.preventDefault();
    const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * 30;
    move(motion("dolly", 0, Math.min(Math.max(pixels / WHEEL_PIXELS, -1), 1) / ZOOM_PER_HEIGHT));
  }, { passive: false });
  stage.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const step = ofKey(event);
    if (step) {
      move(step);
    } else if (event.key === "Enter") {
      pick(0.5, 0.5);
    } else {
      return;
    }
    event.preventDefault();
  });
}
