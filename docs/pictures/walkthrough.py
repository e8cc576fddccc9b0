#!/usr/bin/python3
"""A walk through the editor with mouse and keyboard, as a person would go, and pictures of its steps for the guide.

  dbus-run-session -- docs/pictures/walkthrough.py build/bin/dermis docs/pictures      (with a DISPLAY of 1600 × 1000)

Opens a head, drops a folder of maps on it (the program's own, exported first), chooses an environment, tunes ten
sliders, compares with a snapshot, saves the preset and a picture; then looks whether preset and picture are what was
done. AT-SPI only tells where the controls are: hands are xdotool's. What maps are dragged out of is
`dermis_ui_tests --drag-source` beside the program. Needs xdotool, ImageMagick, openbox or another window manager, and
what tests/ui/assistive.py needs.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import pyatspi

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "ui"))
from assistive import Atspi, application, find, has, wait_for, walk, window  # noqa: E402

# Where ten sliders are let go, as shares of their length.
SLIDERS = [
    ("specular.ior", "Specular › IOR", 0.30),
    ("specular.perceptual_roughness", "Specular › Roughness", 0.38),
    ("specular.lobe_mix", "Specular › Lobe mix", 0.70),
    ("specular.intensity", "Specular › Intensity", 0.62),
    ("specular.cavity", "Specular › Cavity", 0.80),
    ("subsurface.weight", "Subsurface › Weight", 0.90),
    ("subsurface.scale", "Subsurface › Scale", 0.45),
    ("subsurface.albedo_mix", "Subsurface › Albedo mix", 0.35),
    ("transmission.weight", "Transmission › Weight", 0.75),
    ("surface.normal_strength", "Surface › Normal strength", 0.60),
]
MAPS = ("albedo", "normal", "roughness")
ENVIRONMENT = "Window daylight"
SAMPLES = 24


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def box_of(node):
    return node.queryComponent().getExtents(pyatspi.DESKTOP_COORDS)


def move(x, y):
    run("xdotool", "mousemove", str(int(x)), str(int(y)))
    time.sleep(0.1)


def click(node, times=1):
    box = box_of(node)
    move(box.x + box.width / 2, box.y + box.height / 2)
    run("xdotool", "click", "--repeat", str(times), "--delay", "80", "1")
    time.sleep(0.6)


def keys(*names):
    for name in names:
        run("xdotool", "key", "--delay", "60", name)
        time.sleep(0.4)


def type_text(words):
    run("xdotool", "type", "--delay", "15", words)
    time.sleep(0.3)


def drag(x, y, to_x, to_y, steps=10, pause=0.0):
    move(x, y)
    run("xdotool", "mousedown", "1")
    for i in range(1, steps + 1):
        move(x + (to_x - x) * i / steps, y + (to_y - y) * i / steps)
    time.sleep(pause)
    run("xdotool", "mouseup", "1")
    time.sleep(0.4)


def need(name, role, inside=None):
    return wait_for(name, lambda: find(name, role, walk(inside) if inside else None))


def scroll_to(node, above):
    """The wheel over the panel's labels, until the control lies well inside the screen."""
    panel = box_of(above)
    for _ in range(60):
        box = box_of(node)
        if panel.y + panel.height + 24 < box.y < 930:
            return
        move(panel.x + 24, 700)
        run("xdotool", "click", "5" if box.y >= 930 else "4")
        time.sleep(0.15)
    sys.exit(f"{node.name} could not be scrolled to")


def drag_slider(node, share, above):
    scroll_to(node, above)
    value, box = node.queryValue(), box_of(node)
    # The handle is where the value is: a press there moves nothing yet. Past the end stands at the end.
    margin = 6
    length = box.width - 2 * margin
    y = box.y + box.height / 2
    before = value.currentValue
    drag(box.x + margin + 0.5 * length, y, box.x + margin + share * length, y)
    if value.currentValue == before:
        sys.exit(f"{node.name} stayed at {before} when it was dragged")
    return value.currentValue


class Pictures:
    def __init__(self, folder, out):
        self.screen = os.path.join(folder, "screen.png")
        self.out = out
        self.steps = 0

    def settle(self, seconds=240):
        """Until the screen stays as it is."""
        end = time.time() + seconds
        last, same = None, 0
        while time.time() < end and same < 2:
            run("import", "-window", "root", self.screen)
            # The picture alone: what is drawn beside it may go on.
            now = run("convert", self.screen, "-crop", "800x840+400+100", "+repage", "-format", "%#", "info:")
            same = same + 1 if now == last else 0
            last = now
            time.sleep(2.5)

    def take(self):
        self.settle()
        run("import", "-window", "root", self.screen)
        self.steps += 1
        target = os.path.join(self.out, f"walkthrough-{self.steps:02}.jpg")
        run("convert", self.screen, "-resize", "1280x800", "-strip", "-interlace", "Plane", "-quality", "85", target)
        print(target, flush=True)


def drop(source, path, onto):
    """The path from a window of another process, as out of a file manager."""
    box = box_of(onto)
    with subprocess.Popen([source, "--drag-source", path]) as manager:
        found = wait_for("what is dragged out of",
                         lambda: subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^drag source$"],
                                                check=False, capture_output=True, text=True).stdout.split())
        time.sleep(1)
        where = dict(line.split("=") for line in run("xdotool", "getwindowgeometry", "--shell", found[-1]).split())
        drag(int(where["X"]) + 80, int(where["Y"]) + 16, box.x + box.width / 2, box.y + box.height / 2,
             pause=2.0)  # until the editor, which is drawing, has said that it takes them
        time.sleep(1)
        manager.kill()


def export(program, folder):
    """A head and maps on disk, as an artist has them."""
    run(program, "export", "model", "builtin:head", "-o", os.path.join(folder, "head.glb"))
    os.mkdir(os.path.join(folder, "maps"))
    for name in MAPS:
        run(program, "export", "map", f"builtin:head_{name}", "-o", os.path.join(folder, "maps", f"head_{name}.png"))


def file_dialog(title, path):
    dialog = wait_for(title, lambda: window(title))
    need("File name:", pyatspi.ROLE_TEXT, dialog)
    time.sleep(0.5)
    keys("ctrl+a")
    type_text(path)
    keys("Return")
    wait_for(f"the end of {title}", lambda: window(title) is None)


def walk_through(home, source, pictures):
    Atspi.set_timeout(60000, 60000)
    wait_for("the program", application)
    preparing = need("Preparing the picture…", pyatspi.ROLE_LABEL)
    wait_for("the first picture", lambda: not has(preparing, pyatspi.STATE_SHOWING), 240)
    pictures.take()

    # A model, and the question how large it is.
    keys("ctrl+m")
    file_dialog("Open model", os.path.join(home, "head.glb"))
    close = need("Close the question about the model's unit", pyatspi.ROLE_PUSH_BUTTON)
    wait_for("the model", lambda: has(close, pyatspi.STATE_SHOWING), 180)
    pictures.take()
    click(close)

    # Its maps: their folder, from another program onto the panel.
    click(need("Texture maps", pyatspi.ROLE_PAGE_TAB))
    drop(source, os.path.join(home, "maps"), need("Albedo map: choose a file", pyatspi.ROLE_PUSH_BUTTON))
    for name in MAPS:
        need(f"head_{name}.png", pyatspi.ROLE_LABEL)
    pictures.take()

    click(need(ENVIRONMENT, pyatspi.ROLE_LIST_ITEM))
    pictures.take()

    # Ten sliders, after a snapshot to compare with.
    keys("ctrl+t")
    need("Snapshot 1", pyatspi.ROLE_LIST_ITEM)
    click(need("Material", pyatspi.ROLE_PAGE_TAB))
    search = need("Search parameters", pyatspi.ROLE_TEXT)
    tuned = {}
    for key, name, share in SLIDERS:
        tuned[key] = drag_slider(need(name, pyatspi.ROLE_SLIDER), share, search)
    pictures.take()

    keys("c")
    pictures.take()
    keys("c")

    preset = os.path.join(home, "Weathered.json")
    keys("ctrl+shift+p")
    dialog = wait_for("Save preset", lambda: window("Save preset"))
    need("File name:", pyatspi.ROLE_TEXT, dialog)
    keys("ctrl+a")
    type_text(preset)
    keys("Return")
    wait_for("the preset", lambda: os.path.exists(preset))

    picture = os.path.join(home, "weathered.png")
    keys("F12")
    dialog = wait_for("Save a picture", lambda: window("Save a picture"))
    click(need("File", pyatspi.ROLE_TEXT, dialog), 3)
    keys("ctrl+a")
    type_text(picture)
    keys("Return")
    wait_for("the picture", lambda: os.path.exists(picture), 600)
    return tuned, preset, picture


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, out = os.path.abspath(sys.argv[1]), sys.argv[2]
    source = os.path.join(os.path.dirname(program), "dermis_ui_tests")
    with tempfile.TemporaryDirectory() as home:
        export(program, home)
        os.mkdir(os.path.join(home, "Dermis"))
        with open(os.path.join(home, "Dermis", "dermis.conf"), "w", encoding="ascii") as file:
            file.write(f"[preferences]\nstillSamples={SAMPLES}\n")
        environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_DATA_HOME=home,
                           QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1")
        with subprocess.Popen([program], env=environment) as editor:
            try:
                tuned, preset, picture = walk_through(home, source, Pictures(home, out))
            finally:
                editor.kill()
        with open(preset, encoding="utf-8") as file:
            saved = json.load(file)["parameters"]
        wrong = [key for key, value in tuned.items() if abs(saved[key] - value) > 1e-4]
        for key in wrong:
            print(f"{key} was saved as {saved[key]}, not {tuned[key]}")
        size = run("identify", "-format", "%wx%h", picture)
        print(f"{len(tuned) - len(wrong)} of {len(tuned)} sliders are in the preset; the picture is {size}")
        sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
