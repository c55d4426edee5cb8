#!/usr/bin/env python3
"""Pictures of the page of `enlightenment view` in Chromium: docs/guide/view-page.png and docs/guide/view-turn.gif.

    python3 src/bench/scripts/view_turn.py JAR SCENE page OUT.png [light|dark] [WIDTH HEIGHT]
    python3 src/bench/scripts/view_turn.py JAR SCENE turn OUT.gif

`page` shows the page once its picture has some samples, with a pixel chosen. `turn` drags the scene to and fro with the mouse and
takes the page after each step, once that many samples are there; it needs Pillow. Chromium must be on the path.
"""
import base64
import io
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

PATIENCE_SECONDS = 240
STEPS = 16
SAMPLES = 4
STILL_SAMPLES = 6
# Of the drag to either side, in pixels of a page of this size.
REACH = 42
PAGE = (960, 456)
SHOWN = (640, 304)
COLOURS = 192


class Page:
    """A page of a browser without a window, spoken to over a pipe: JSON texts that end with a zero byte."""

    def __init__(self):
        browser = next(b for b in map(shutil.which, ("chromium", "chromium-browser", "google-chrome")) if b)
        self.profile = tempfile.mkdtemp()
        shell = 'exec "$@" 3<&0 4>&1 </dev/null >/dev/null 2>&1'
        self.process = subprocess.Popen(
            ["sh", "-c", shell, "sh", browser, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
             "--user-data-dir=" + self.profile, "about:blank"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.calls = 0
        self.rest = b""
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    def call(self, method, **params):
        self.calls += 1
        message = {"id": self.calls, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        self.process.stdin.write(json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.rest:
                more = self.process.stdout.read(1 << 16)
                if not more:
                    sys.exit("the browser has ended")
                self.rest += more
            text, self.rest = self.rest.split(b"\0", 1)
            answer = json.loads(text)
            if answer.get("id") == self.calls:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]

    def value(self, expression):
        return self.call("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def until(self, expression):
        end = time.monotonic() + PATIENCE_SECONDS
        while not self.value(expression):
            if time.monotonic() > end:
                sys.exit("waited in vain until " + expression)
            time.sleep(0.05)

    def mouse(self, kind, x, y):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)

    def look(self, width, height, scheme):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 720)
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def picture(self):
        return base64.b64decode(self.call("Page.captureScreenshot")["data"])

    def close(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)


def samples(least):
    """True in the page when its picture, as large as it will be, has so many samples."""
    return ("(() => { const t = /^([0-9]+) × ([0-9]+), ([0-9]+) samples? per/.exec(document.querySelector('#progress')?.textContent);"
            " const s = document.querySelector('#stage'), i = document.querySelector('#picture');"
            " return t && t[3] >= %d && i.complete && i.naturalWidth == t[1]"
            " && (Math.abs(s.clientWidth - t[1]) < 2 || Math.abs(s.clientHeight - t[2]) < 2); })()" % least)


def middle(page):
    box = page.value("(b => [b.left + b.width / 2, b.top + b.height / 2])(document.querySelector('#picture').getBoundingClientRect())")
    return box[0], box[1]


def still(page, out):
    page.until(samples(STILL_SAMPLES))
    x, y = middle(page)
    page.mouse("mousePressed", x, y)
    page.mouse("mouseReleased", x, y)
    page.until("!document.querySelector('#pixel').hidden")
    with open(out, "wb") as file:
        file.write(page.picture())


def turn(page, out):
    from PIL import Image

    page.until(samples(SAMPLES))
    x, y = middle(page)
    page.mouse("mousePressed", x, y)
    frames = []
    for step in range(STEPS):
        before = page.value("document.querySelector('#picture').src")
        angle = 2 * math.pi * (step + 1) / STEPS
        page.mouse("mouseMoved", x + REACH * math.sin(angle), y + REACH / 4 * (1 - math.cos(angle)))
        page.until("document.querySelector('#picture').src != " + json.dumps(before))
        # The state may still be that of the step before, whose samples are all there.
        time.sleep(0.3)
        page.until(samples(SAMPLES))
        image = Image.open(io.BytesIO(page.picture())).convert("RGB").resize(SHOWN, Image.LANCZOS)
        frames.append(image)
        print("step", step + 1, "of", STEPS, flush=True)
    page.mouse("mouseReleased", x, y)
    # One palette for all frames: what does not change then does not cost anything.
    sheet = Image.new("RGB", (SHOWN[0], SHOWN[1] * len(frames)))
    for n, frame in enumerate(frames):
        sheet.paste(frame, (0, n * SHOWN[1]))
    palette = sheet.quantize(COLOURS, method=Image.MEDIANCUT, dither=Image.Dither.NONE)
    flat = [f.quantize(palette=palette, dither=Image.Dither.NONE) for f in frames]
    flat[0].save(out, save_all=True, append_images=flat[1:], duration=120, loop=0, optimize=True)
    print(out, os.path.getsize(out), "bytes")


def main():
    jar, scene, what, out = sys.argv[1:5]
    scheme = sys.argv[5] if len(sys.argv) > 5 else "light"
    size = tuple(map(int, sys.argv[6:8])) or ((1120, 630) if what == "page" else PAGE)
    view = subprocess.Popen(
        ["java", "-jar", jar, "view", scene, "--samples", "64" if what == "page" else str(SAMPLES)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    page = None
    try:
        address = None
        while not address:
            line = view.stdout.readline()
            if not line:
                sys.exit("the view has ended")
            address = next((word for word in line.split() if word.startswith("http://")), None)
        page = Page()
        page.look(*size, scheme)
        page.call("Page.navigate", url=address)
        still(page, out) if what == "page" else turn(page, out)
    finally:
        if page:
            page.close()
        view.terminate()
        view.wait()


if __name__ == "__main__":
    main()
