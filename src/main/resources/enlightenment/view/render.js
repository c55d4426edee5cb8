// The final render of what is seen: its settings, how it gets on, and its files.
const at = id => document.getElementById(id);
const key = location.hash.slice(1);
const sleep = millis => new Promise(done => setTimeout(done, millis));
const url = (path, parameters) => path + "?" + new URLSearchParams({ key, ...parameters });

let status = null;
// Whether the size was chosen here; until then it is the file's.
let isSized = false;

const seconds = s => s < 60 ? Math.round(s) + " s" : s < 3600 ? Math.round(s / 60) + " min" : (s / 3600).toFixed(1) + " h";

function words(s) {
  const size = s.width + " × " + s.height;
  switch (s.state) {
    case "running": {
      const left = s.done > 0.02 ? ", about " + seconds(s.seconds * (1 - s.done) / s.done) + " left" : "";
      return size + ", " + Math.floor(100 * s.done) + " %, " + seconds(s.seconds) + left;
    }
    case "done": return size + ", done in " + seconds(s.seconds);
    case "cancelled": return "Cancelled.";
    case "failed": return "It failed:";
    default: return "";
  }
}

function fillForm(scene) {
  const method = at("method");
  const offered = ["", ...scene.methods];
  if (offered.join() !== [...method.options].map(o => o.value).join()) {
    const chosen = method.value;
    method.replaceChildren(...offered.map(word => new Option(word, word)));
    method.value = offered.includes(chosen) ? chosen : "";
  }
  method.options[0].textContent = "as in the file: " + scene.method;
  if (!isSized) {
    at("width").value = scene.width;
    at("height").value = scene.height;
  }
}

function show(s) {
  status = s;
  const isRunning = s.state === "running";
  fillForm(s.scene);
  at("start").disabled = isRunning;
  at("cancel").hidden = !isRunning;
  at("done").hidden = !isRunning;
  at("done").value = s.done;
  at("course").textContent = words(s);
  at("notes").textContent = s.notes.join("\n");
  at("notes").hidden = !s.notes.length;
  at("files").hidden = s.state !== "done";
  if (s.state === "done") {
    const name = at("title").textContent.replace(/\.[^.]*$/, "") || "picture";
    for (const kind of ["png", "exr"]) {
      at(kind).href = url("render." + kind, { n: s.version });
      at(kind).download = name + "." + kind;
    }
  }
}

async function watch() {
  for (let version = 0; ;) {
    try {
      const answer = await fetch(url("render.json", { after: version }));
      if (answer.status === 403) {
        return;
      }
      if (answer.ok) {
        const s = await answer.json();
        version = s.version;
        show(s);
        continue;
      }
    } catch (e) {
      version = 0;
    }
    await sleep(1000);
  }
}

async function act(parameters) {
  let text;
  try {
    const answer = await fetch(url("do", parameters), { method: "POST" });
    text = answer.ok ? "" : (await answer.text()).trim();
  } catch (e) {
    text = "There is no answer.";
  }
  if (text) {
    at("notes").textContent = text;
    at("notes").hidden = false;
  }
}

function asked() {
  const order = { action: "render", width: at("width").value, height: at("height").value };
  if (at("method").value) {
    order.method = at("method").value;
  }
  if (at("quality").value) {
    order[at("quality").value] = at("amount").value;
  }
  return order;
}

at("order").addEventListener("submit", event => {
  event.preventDefault();
  act(asked());
});
at("cancel").addEventListener("click", () => act({ action: "cancel" }));
at("quality").addEventListener("change", () => {
  const kind = at("quality").value;
  at("amount").hidden = !kind;
  at("amount").disabled = !kind;
  at("amount").setAttribute("aria-label", kind === "error" ? "largest error" : "samples per pixel");
  at("amount").min = kind === "error" ? 1e-7 : 1;
  at("amount").max = kind === "error" ? 1 : 1 << 24;
  at("amount").value = kind === "error" ? 0.01 : 64;
});
at("width").addEventListener("input", () => {
  isSized = true;
  const width = Number(at("width").value);
  if (status && width >= 1) {
    at("height").value = Math.max(Math.round(width * status.scene.height / status.scene.width), 1);
  }
});
at("height").addEventListener("input", () => { isSized = true; });
watch();
