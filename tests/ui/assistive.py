#!/usr/bin/python3
"""Uses the editor through AT-SPI, as a screen reader does.

  dbus-run-session -- python3 tests/ui/assistive.py build/bin/dermis      (with a DISPLAY)

Raises every panel and opens the dialogs of the menus, and fails where a control has no name or no role; sets ten
parameters by their names, through sliders, fields, text with units, a choice, a tick box and a colour's channel, and
reads each back; saves a preset through the menu and looks for the ten values in its file. Exit code 0: all is well.

Needs at-spi2-core, dbus-daemon and python3-pyatspi. The program runs under a locale with a decimal comma where one can
be made (localedef).
"""
import json
import os
import subprocess
import sys
import tempfile
import time
import typing

import gi
import pyatspi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402

# Roles that say nothing of what a control does.
NO_ROLE = {pyatspi.ROLE_INVALID, pyatspi.ROLE_UNKNOWN, pyatspi.ROLE_FILLER, pyatspi.ROLE_PANEL}
CONTROLS = {
    pyatspi.ROLE_PUSH_BUTTON, pyatspi.ROLE_TOGGLE_BUTTON, pyatspi.ROLE_CHECK_BOX, pyatspi.ROLE_RADIO_BUTTON,
    pyatspi.ROLE_COMBO_BOX, pyatspi.ROLE_SLIDER, pyatspi.ROLE_SPIN_BUTTON, pyatspi.ROLE_ENTRY, pyatspi.ROLE_TEXT,
    pyatspi.ROLE_MENU_ITEM, pyatspi.ROLE_PAGE_TAB, pyatspi.ROLE_LIST, pyatspi.ROLE_LIST_ITEM, pyatspi.ROLE_TREE,
    pyatspi.ROLE_TABLE, pyatspi.ROLE_COLOR_CHOOSER, pyatspi.ROLE_CANVAS, pyatspi.ROLE_CHART,
}
# Text that may be selected, and what stands in a table: the keyboard reaches it, but there is nothing to do there.
CONTENT = {pyatspi.ROLE_LABEL, pyatspi.ROLE_TABLE_CELL}
DIALOGS = {"Preferences…": "Preferences", "Keyboard shortcuts…": "Keyboard shortcuts", "Save a picture…": "Save a picture"}

ESCAPE = 0xFF1B  # X11's keysym

# The parameter, the control's name and role, how it is set, and what the preset's file then says.
SLIDER, FIELD = pyatspi.ROLE_SLIDER, pyatspi.ROLE_SPIN_BUTTON
WANTED = [
    ("subsurface.scale", "Subsurface › Scale", SLIDER, 2.5, 2.5),
    ("subsurface.weight", "Subsurface › Weight", FIELD, 0.75, 0.75),
    ("subsurface.radius_mm", "Subsurface › Radius R", SLIDER, 4.5, [4.5, None, None]),
    ("subsurface.radius_reading", "Subsurface › Radius reading", pyatspi.ROLE_COMBO_BOX, "Mean free path", "mean_free_path"),
    ("specular.ior", "Specular › IOR", FIELD, 1.5, 1.5),
    # Beginning with the reflectance that follows from the index of refraction above.
    ("specular.f0", "Specular › Fresnel F0, own value", pyatspi.ROLE_CHECK_BOX, True, [0.04] * 3),
    ("specular.perceptual_roughness", "Specular › Roughness", FIELD, "0,625", 0.625),
    ("transmission.thickness_max_mm", "Transmission › Thickness max", FIELD, "1.25 cm", 12.5),
    ("transmission.weight", "Transmission › Weight", SLIDER, 0.375, 0.375),
    ("base.albedo", "Base › Albedo, linear G", FIELD, 0.5, [None, 0.5, None]),
]


class Seen(typing.NamedTuple):
    node: Atspi.Accessible
    role: int
    name: str


def walk(node):
    """Every accessible below `node`, and itself; those that go while they are looked at are left out."""
    try:
        seen = Seen(node, node.getRole(), node.name)
        children = node.childCount
    except (GLib.GError, AttributeError):
        return
    yield seen
    for i in range(children):
        try:
            child = node.getChildAtIndex(i)
        except GLib.GError:
            return
        yield from walk(child)


def wait_for(what, find, seconds=60):
    end = time.time() + seconds
    while time.time() < end:
        found = find()
        if found:
            return found
        time.sleep(0.1)
    sys.exit(f"{what} did not appear within {seconds} s")


def application():
    desktop = pyatspi.Registry.getDesktop(0)
    return next((a for a in desktop if a is not None and a.name == "dermis"), None)


def window(name):
    return next((w for w in application() if w is not None and w.name == name), None)


def find(name, role, seen=None):
    """The control of this name and role, of those seen or of all there are."""
    found = (s.node for s in (seen if seen is not None else walk(application())) if s.role == role and s.name == name)
    return next(found, None)


def has(node, state):
    return node.getState().contains(state)


def press(node):
    """What a press opens may answer only when it is closed: not waiting for that is no failure."""
    action = node.queryAction()
    Atspi.set_timeout(1500, 1500)
    try:
        action.doAction(0)
    except GLib.GError:
        pass
    finally:
        Atspi.set_timeout(30000, 30000)


def press_escape():
    pyatspi.Registry.generateKeyboardEvent(0xFF1B, None, pyatspi.KEY_SYM)


class Census:
    """Controls seen, and what is wrong with them."""

    def __init__(self):
        self.controls = 0
        self.accessibles = 0
        self.faults = []

    def look(self, root, where):
        seen = list(walk(root))
        self.accessibles += len(seen)
        for node, role, name in seen:
            # By its role, or because the keyboard reaches it.
            if role not in CONTROLS and (role in CONTENT or not has(node, pyatspi.STATE_FOCUSABLE)):
                continue
            if role == pyatspi.ROLE_PAGE_TAB_LIST and all(s.role != pyatspi.ROLE_PAGE_TAB for s in walk(node)):
                continue  # Qt keeps bars without tabs for later
            self.controls += 1
            if not name:
                parent = node.parent.name if node.parent else ""
                self.faults.append(f"{where}: a {node.getRoleName()} in “{parent}” has no name")
            if role in NO_ROLE:
                self.faults.append(f"{where}: “{name}” has no role but {node.getRoleName()}")
        return seen


def raise_panels(census, seen):
    """Each panel's tab is pressed, which has to bring the panel forward."""
    tabs = [s for s in seen if s.role == pyatspi.ROLE_PAGE_TAB]
    for node, _, name in tabs:
        press(node)
        panels = [s.node for s in seen if s.name == name and s.role != pyatspi.ROLE_PAGE_TAB and s.role not in CONTROLS]
        if not any(has(panel, pyatspi.STATE_SHOWING) for panel in panels):
            census.faults.append(f"pressing the tab “{name}” did not bring its panel forward")
    return len(tabs)


def look_at_dialogs(census, seen):
    for item, title in DIALOGS.items():
        press(find(item, pyatspi.ROLE_MENU_ITEM, seen))
        dialog = wait_for(f"the dialog of {item}", lambda title=title: window(title))
        inside = census.look(dialog, title)
        close = [s.node for s in inside if s.role == pyatspi.ROLE_PUSH_BUTTON and s.name in ("Cancel", "Close")]
        if not close:
            sys.exit(f"{title} has no Cancel and no Close")
        press(close[0])
        wait_for(f"the end of {title}", lambda title=title: window(title) is None)


def set_control(node, role, value):
    if role == pyatspi.ROLE_COMBO_BOX:
        press(find(value, pyatspi.ROLE_LIST_ITEM, walk(node)))
    elif role == pyatspi.ROLE_CHECK_BOX:
        if has(node, pyatspi.STATE_CHECKED) != value:
            press(node)
    elif isinstance(value, str):
        node.queryEditableText().setTextContents(value)
    else:
        node.queryValue().currentValue = value


def read_control(node, role):
    """What the control says it holds now."""
    if role == pyatspi.ROLE_COMBO_BOX:
        items = [s for s in walk(node) if s.role == pyatspi.ROLE_LIST_ITEM]
        return next((s.name for s in items if has(s.node, pyatspi.STATE_SELECTED)), None)
    if role == pyatspi.ROLE_CHECK_BOX:
        return has(node, pyatspi.STATE_CHECKED)
    return node.queryValue().currentValue


def same(a, b):
    if a is None or b is None:
        return a is b
    if isinstance(b, list):
        return all(want is None or abs(got - want) < 1e-5 for got, want in zip(a, b, strict=True))
    if isinstance(b, float):
        return abs(a - b) < 1e-5
    return a == b


def set_and_read(name, role, value, saved, seen):
    """What went wrong, or nothing."""
    control = find(name, role, seen)
    if control is None:
        return f"nothing of role {role} is called {name}"
    set_control(control, role, value)
    wanted = saved if isinstance(value, str) and role == FIELD else value
    read = read_control(control, role)
    return None if same(read, wanted) else f"{name} reads {read} after it was set to {value}"


def picker_below(swatch):
    swatch.clear_cache()
    return swatch.getChildAtIndex(0) if swatch.childCount else None


def set_in_picker(name, role, value, saved, seen):
    """A colour's channel: its picker opens from the colour's button, and Esc closes it."""
    colour = name.split(",")[0]
    swatch = find(colour, pyatspi.ROLE_PUSH_BUTTON, seen)
    press(swatch)
    picker = wait_for("the colour picker", lambda: picker_below(swatch), 10)
    fault = set_and_read(name, role, value, saved, list(walk(picker)))
    pyatspi.Registry.generateKeyboardEvent(ESCAPE, None, pyatspi.KEY_SYM)
    wait_for("the end of the colour picker", lambda: picker_below(swatch) is None, 10)
    return fault


def save_preset(item, preset):
    press(item)
    dialog = wait_for("the file dialog", lambda: window("Save preset"))
    inside = list(walk(dialog))
    find("File name:", pyatspi.ROLE_TEXT, inside).queryEditableText().setTextContents(preset)
    press(find("Save", pyatspi.ROLE_PUSH_BUTTON, inside))
    wait_for("the preset", lambda: os.path.exists(preset), 20)
    with open(preset, encoding="utf-8") as file:
        return json.load(file)["parameters"]


def use(home):
    # Between two pictures of a software renderer there may be seconds.
    Atspi.set_timeout(30000, 30000)
    started = time.time()
    wait_for("the program", application)
    wait_for("the window", lambda: find("Subsurface › Scale", SLIDER))
    census = Census()
    panels = raise_panels(census, list(walk(application())))
    seen = census.look(application(), "window")
    look_at_dialogs(census, seen)
    print(f"{census.controls} controls in {census.accessibles} accessibles, {panels} tabs, {len(DIALOGS)} dialogs: "
          f"{time.time() - started:.1f} s")

    faults = census.faults
    for _, name, role, value, saved in WANTED:
        fault = (set_in_picker if "linear" in name else set_and_read)(name, role, value, saved, seen)
        faults += [fault] if fault else []
    saved = save_preset(find("Save preset as…", pyatspi.ROLE_MENU_ITEM, seen), os.path.join(home, "spoken.json"))
    wrong = [key for key, _, _, _, value in WANTED if not same(saved[key], value)]
    faults += [f"{key} was saved as {saved[key]}" for key in wrong]
    print(f"{len(WANTED) - len(wrong)} of {len(WANTED)} parameters set and saved: {time.time() - started:.1f} s")
    for fault in faults:
        print("  " + fault)
    return 1 if faults else 0


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
        # Few samples: the processor is needed for the questions.
        os.mkdir(os.path.join(home, "Dermis"))
        with open(os.path.join(home, "Dermis", "dermis.conf"), "w", encoding="ascii") as file:
            file.write("[preferences]\nstillSamples=4\n")
        with subprocess.Popen([sys.argv[1], scene], env=environment) as program:
            try:
                return use(home)
            finally:
                program.kill()


if __name__ == "__main__":
    sys.exit(main())
