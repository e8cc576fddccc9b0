#!/usr/bin/python3
"""Uses the editor through AT-SPI, as a screen reader does: no control without a name; ten parameters set, a preset saved.

  dbus-run-session -- xvfb-run -a python3 tests/ui/assistive.py build/bin/dermis

Run by hand (packages at-spi2-core, python3-pyatspi, dbus-daemon), on a machine that is not busy. The program runs under a locale with a decimal comma, where one can be made (localedef). Exit code 0: all is well.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

import gi
import pyatspi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi  # noqa: E402

WANTED = {
    "subsurface.scale": ("Subsurface › Scale", 2.5),
    "subsurface.weight": ("Subsurface › Weight", 0.75),
    "subsurface.albedo_mix": ("Subsurface › Albedo mix", 0.25),
    "specular.perceptual_roughness": ("Specular › Roughness", 0.625),
    "specular.lobe_mix": ("Specular › Lobe mix", 0.5),
    "specular.ior": ("Specular › IOR", 1.5),
    "specular.intensity": ("Specular › Intensity", 0.875),
    "transmission.weight": ("Transmission › Weight", 0.375),
    "transmission.thickness_max_mm": ("Transmission › Thickness max", 12.5),
    "surface.normal_strength": ("Surface › Normal strength", 1.25),
}

CONTROLS = {
    pyatspi.ROLE_PUSH_BUTTON, pyatspi.ROLE_TOGGLE_BUTTON, pyatspi.ROLE_CHECK_BOX, pyatspi.ROLE_RADIO_BUTTON,
    pyatspi.ROLE_COMBO_BOX, pyatspi.ROLE_SLIDER, pyatspi.ROLE_SPIN_BUTTON, pyatspi.ROLE_ENTRY, pyatspi.ROLE_TEXT,
    pyatspi.ROLE_MENU_ITEM, pyatspi.ROLE_PAGE_TAB, pyatspi.ROLE_LIST, pyatspi.ROLE_TREE, pyatspi.ROLE_TABLE,
    pyatspi.ROLE_COLOR_CHOOSER,
}


def walk(node, inside_combo=False):
    """Every accessible below `node`; a combo box's own list has the name of its box."""
    if node is None:
        return
    if not inside_combo:
        yield node
    combo = inside_combo or node.getRole() == pyatspi.ROLE_COMBO_BOX
    for i in range(node.childCount):
        yield from walk(node.getChildAtIndex(i), combo)


def wait_for(what, find, seconds=60):
    end = time.time() + seconds
    while time.time() < end:
        found = find()
        if found:
            return found
        time.sleep(0.2)
    sys.exit(f"{what} did not appear within {seconds} s")


def application():
    desktop = pyatspi.Registry.getDesktop(0)
    return next((a for a in desktop if a is not None and a.name == "dermis"), None)


def wait_until_quiet():
    """A software renderer keeps the window busy while its picture is refined; a walk between two frames takes ages."""
    quiet = 0
    end = time.time() + 300
    while quiet < 8 and time.time() < end:
        start = time.time()
        app = application()
        quiet = quiet + 1 if app is not None and app.childCount > 0 and time.time() - start < 0.1 else 0
        time.sleep(0.25)


def find(name, role, nodes=None):
    found = (n for n in (nodes if nodes is not None else walk(application())) if n.getRole() == role and n.name == name)
    return next(found, None)


def press(node):
    """A dialog that opens answers the press only when it closes: not waiting for that is no failure."""
    try:
        node.queryAction().doAction(0)
    except Exception as error:  # GLib's own class of errors, which depends on how it was bound
        print("pressed", node.name, "without an answer yet:", error)


def comma_locale(folder):
    """A locale with a decimal comma in LOCPATH, so that none need be installed."""
    source = os.path.join(folder, "comma")
    with open(source, "w", encoding="ascii") as file:
        file.write('LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
    made = subprocess.run(["localedef", "-c", "-i", source, "-f", "ANSI_X3.4-1968", os.path.join(folder, "xx_XX")],
                          capture_output=True, check=False)
    return {"LOCPATH": folder, "LC_NUMERIC": "xx_XX"} if made.returncode <= 1 else {}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as home:
        environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_CACHE_HOME=home, XDG_DATA_HOME=home,
                           QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", **comma_locale(home))
        # A ball is drawn faster than the head where the processor draws.
        scene = os.path.join(home, "ball.dermis")
        with open(scene, "w", encoding="ascii") as file:
            json.dump({"format": "dermis.scene", "version": 1, "model": {"builtin": "sphere"}}, file)
        with subprocess.Popen([sys.argv[1], scene], env=environment) as program:
            try:
                use(home)
            finally:
                program.kill()


def use(home):
    # Between two frames of a software renderer there may be seconds.
    Atspi.set_timeout(30000, 30000)
    wait_for("the program", application)
    wait_until_quiet()
    controls = [n for n in walk(application()) if n.getRole() in CONTROLS]
    nameless = [n for n in controls if not n.name]
    print(f"{len(controls)} controls, {len(nameless)} without a name")
    for node in nameless:
        print("  no name:", node.getRoleName(), "in", node.parent.name if node.parent else "nothing")

    for path, value in WANTED.values():
        # Half of them by their sliders, half by their fields.
        role = pyatspi.ROLE_SLIDER if value >= 0.7 else pyatspi.ROLE_SPIN_BUTTON
        control = find(path, role, controls)
        if control is None:
            sys.exit(f"no {role} is called {path}")
        control.queryValue().currentValue = value

    preset = os.path.join(home, "spoken.json")
    wait_until_quiet()
    press(find("Save preset as…", pyatspi.ROLE_MENU_ITEM, controls))
    dialog = wait_for("the file dialog", lambda: next((w for w in application() if w.name == "Save preset"), None))
    inside = list(walk(dialog))
    find("File name:", pyatspi.ROLE_TEXT, inside).queryEditableText().setTextContents(preset)
    press(find("Save", pyatspi.ROLE_PUSH_BUTTON, inside))
    wait_for("the preset", lambda: os.path.exists(preset), 20)

    with open(preset, encoding="utf-8") as file:
        saved = json.load(file)["parameters"]
    wrong = {key: saved[key] for key, (_, value) in WANTED.items() if abs(saved[key] - value) > 1e-6}
    for key, value in wrong.items():
        print(f"{key} is {value}, not {WANTED[key][1]}")
    print(f"{len(WANTED) - len(wrong)} of {len(WANTED)} parameters set and saved")
    sys.exit(1 if wrong or nameless else 0)


if __name__ == "__main__":
    main()
