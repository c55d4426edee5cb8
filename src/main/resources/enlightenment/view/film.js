// The frames of an animation: a slider, steps, and playing, in real time: what takes longer to render than it is shown is left out.
const at = id => document.getElementById(id);
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const CALM_FRAMES_PER_SECOND = 1;

/**
 * Listens to the controls of frames.
 * @param stage has the keys
 * @param send takes the action that shows a frame
 * @return takes each new state of the view
 */
export function film(stage, send) {
  let state = { frames: 0 };
  let asked = null;
  // The first picture of the frame that was asked for; null until there is one.
  let first = null;
  let playing = null;

  function write() {
    const frame = asked ?? state.frame;
    at("frame").textContent = (frame === null ? "–" : frame) + " of " + (state.frames - 1);
    at("frames").value = frame ?? 0;
    at("play").textContent = playing ? "Pause" : "Play";
  }

  function go(frame) {
    asked = (frame + state.frames) % state.frames;
    first = null;
    send({ action: "frame", x: asked, replaces: true });
    write();
  }

  function step(by) {
    pause();
    go((asked ?? state.frame ?? (by > 0 ? -1 : 1)) + by);
  }

  /** The number of the picture that can be seen. */
  function seen() {
    return Number(new URL(at("picture").src, location).searchParams.get("n"));
  }

  function pause() {
    playing = null;
    write();
  }

  function play() {
    if (playing) {
      pause();
      return;
    }
    const from = asked ?? state.frame ?? 0;
    playing = { from, since: performance.now() };
    go(from);
    requestAnimationFrame(tick);
  }

  // While the page is hidden there are no animation frames: nothing is rendered for nobody.
  function tick(now) {
    if (!playing) {
      return;
    }
    const rate = calm.matches ? CALM_FRAMES_PER_SECOND : state.framesPerSecond;
    const passed = Math.max(Math.floor((now - playing.since) / 1000 * rate), 0);
    const frame = (playing.from + passed) % state.frames;
    if (frame !== asked && first !== null && seen() >= first) {
      go(frame);
    }
    requestAnimationFrame(tick);
  }

  at("frames").addEventListener("input", e => {
    playing = null;
    go(Number(e.target.value));
  });
  at("earlier").addEventListener("click", () => step(-1));
  at("later").addEventListener("click", () => step(1));
  at("play").addEventListener("click", play);
  stage.addEventListener("keydown", event => {
    const action = { ",": () => step(-1), ".": () => step(1), " ": play }[event.key];
    if (action && state.frames && !event.ctrlKey && !event.metaKey && !event.altKey) {
      action();
      event.preventDefault();
    }
  });

  return s => {
    state = s;
    at("film").hidden = !s.frames;
    if (!s.frames) {
      playing = null;
      return;
    }
    at("frames").max = s.frames - 1;
    if (first === null && s.current && s.frame === asked) {
      first = s.picture;
    }
    // Another page may have chosen a frame.
    if (!playing && first !== null && s.frame !== asked) {
      asked = s.frame;
    }
    write();
  };
}
