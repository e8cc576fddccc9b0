#!/usr/bin/env python3
"""Renders the scenes of a folder of reference curves and pictures and compares, as docs/validation.md describes.

    tests/validation/references.py REFERENCE ASSETS OUT [--dermis build/bin/dermis] [--only edge|sphere|slabs|head]

REFERENCE holds step_edge_*.csv, slabs_random_walk.csv, sphere_r10mm_random_walk.csv and head_front_path_traced*.exr (made
with Cycles 3.4 random walks and numpy); ASSETS holds lee_perry_smith/ and hdri/. Neither is part of this project. Needs
python3-numpy, python3-matplotlib and openimageio-tools. Prints one line a figure; plots and difference pictures go to OUT.
"""
import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot
import numpy

from pictures import material, read_csv, read_exr, render, write_obj

COLOURS = ("#c0392b", "#27ae60", "#2980b9")
# The volume of the reference, as its README gives it: reduced mean free path in mm, and the albedo that it makes.
WALK = {"base.albedo": [0.8, 0.5, 0.4], "subsurface.radius_reading": "mean_free_path",
        "subsurface.radius_mm": [0.2628, 0.3537, 0.2476], "subsurface.profile": "burley"}
NO_LAYER = {"specular.intensity": 0, "transmission.weight": 0}
DARK = {"constant": [0, 0, 0], "background": "none"}


def percent(value):
    return "%.2f %%" % (100 * value)


def edge_scene(folder, look, size_mm, tilt_degrees=0):
    """A plane whose half x > 0 is lit: a blocker 50 mm above and beside the view casts a straight edge onto the y axis."""
    plane = write_obj(os.path.join(folder, "plane.obj"), [(-60, -60, 0), (60, -60, 0), (60, 60, 0), (-60, 60, 0)], [(1, 2, 3, 4)])
    blocker = write_obj(os.path.join(folder, "blocker.obj"), [(-400, -400, 50), (-50, -400, 50), (-50, 400, 50), (-400, 400, 50)],
                        [(1, 2, 3, 4)])
    tilt = numpy.radians(tilt_degrees)
    camera = {"position": [100 * numpy.sin(tilt), 0, 100 * numpy.cos(tilt)], "target": [0, 0, 0], "up": [0, 1, 0],
              "orthographic_height": size_mm}
    return {"model": {"parts": [{"path": plane}, {"path": blocker}], "millimetres_per_unit": 1},
            "materials": {"*": material(dict(NO_LAYER, **look))}, "environment": DARK, "camera": camera,
            "lights": [{"type": "directional", "direction": [1, 0, -1], "intensity": 1, "shadow": True}]}


def edges(arguments):
    walk = read_csv(os.path.join(arguments.reference, "step_edge_random_walk_skin.csv"))
    gaussians = read_csv(os.path.join(arguments.reference, "step_edge_gaussians.csv"))
    plateau = numpy.array([0.810, 0.506, 0.404])
    cases = {"burley against random walks": (WALK, [walk[c] for c in "RGB"], True),
             "gaussians against the exact edge": (dict(WALK, **{"subsurface.profile": "gaussians"}), [gaussians[c] for c in "RGB"], False)}
    for name, (look, curves, divide) in cases.items():
        x_reference = (walk if divide else gaussians)["x_mm"]
        figure, axes = plot.subplots(2, 1, figsize=(8, 7), sharex=True, height_ratios=(3, 1))
        for pixels, tilt in ((100, 0), (200, 0), (400, 0), (200, 45)):
            view_mm = 20.0
            output = os.path.join(arguments.out, "edge-%s-%d-%d.exr" % (name.split()[0], pixels, tilt))
            layers = render(arguments.dermis, edge_scene(arguments.out, look, view_mm * 0.8, tilt), output, (pixels, pixels * 4 // 5),
                            64, ["diffuse_scattered"])
            middle = pixels * 2 // 5
            rows = layers["diffuse_scattered"][middle - 4:middle + 4, :, :3].mean(axis=0)
            # On the surface: a tilted view shows more of it in a pixel.
            x = ((numpy.arange(pixels) + 0.5) / pixels - 0.5) * view_mm / numpy.cos(numpy.radians(tilt))
            rows, x = rows[abs(x) < 10], x[abs(x) < 10]
            mine = rows / rows[x > 8].mean(axis=0)
            for c in range(3):
                theirs = numpy.interp(x, x_reference, curves[c])
                theirs = theirs / numpy.interp(9.0, x_reference, curves[c])
                difference = mine[:, c] - theirs
                print("edge, %s, %d px over 20 mm, %d°, %s: RMSE %s, worst %s" %
                      (name, pixels, tilt, "RGB"[c], percent(numpy.sqrt((difference**2).mean())), percent(abs(difference).max())))
                if pixels == 400:
                    axes[0].plot(x, mine[:, c], color=COLOURS[c], lw=1.5, label="ours, %s" % "RGB"[c])
                    axes[0].plot(x, theirs, color="black", lw=0.8, ls="--", label="reference" if c == 2 else None)
                    axes[1].plot(x, 100 * difference, color=COLOURS[c], lw=1)
        axes[0].set(title="Step of light: " + name, ylabel="share of the plateau", xlim=(-8, 8))
        axes[1].set(xlabel="mm from the edge", ylabel="difference, %")
        axes[0].legend(frameon=False)
        figure.tight_layout()
        figure.savefig(os.path.join(arguments.out, "edge-%s.png" % name.split()[0]), dpi=80)


def sphere(arguments):
    reference = read_csv(os.path.join(arguments.reference, "sphere_r10mm_random_walk.csv"))
    width = len(reference["x_mm"])
    pixel_mm = reference["x_mm"][1] - reference["x_mm"][0]
    scene = {"model": {"builtin": "sphere", "millimetres_per_unit": 10}, "materials": {"*": material(dict(NO_LAYER, **WALK))},
             "environment": DARK, "camera": {"position": [0, 0, 6], "target": [0, 0, 0], "orthographic_height": 33 * pixel_mm / 10},
             "lights": [{"type": "directional", "direction": [-1, 0, 0], "intensity": float(numpy.pi)}]}
    layers = render(arguments.dermis, scene, os.path.join(arguments.out, "sphere.exr"), (width, 33), 256,
                    ["diffuse_scattered", "diffuse"])
    mine = layers["diffuse_scattered"][16, :, :3]
    lambert = layers["diffuse"][16, :, :3]
    x = reference["x_mm"]
    figure, axes = plot.subplots(2, 1, figsize=(8, 7), sharex=True, height_ratios=(3, 1))
    for c in range(3):
        lit = (x > 4) & (x < 8)
        theirs = reference["RGB"[c]] / (reference["RGB"[c]][lit] / reference["lambert" + "RGB"[c]][lit]).mean()
        ours = mine[:, c] / (mine[:, c][lit] / lambert[:, c][lit]).mean()
        inside = numpy.abs(x) < 9.5
        plateau = reference["lambert" + "RGB"[c]].max()
        difference = (ours - theirs)[inside] / plateau
        print("sphere of 10 mm, %s: RMSE %s, worst %s of the plateau" %
              ("RGB"[c], percent(numpy.sqrt((difference**2).mean())), percent(abs(difference).max())))
        axes[0].plot(x, ours, color=COLOURS[c], lw=1.5, label="ours, %s" % "RGB"[c])
        axes[0].plot(x, theirs, color="black", lw=0.8, ls="--", label="random walk" if c == 2 else None)
        axes[1].plot(x[inside], 100 * difference, color=COLOURS[c], lw=1)
    axes[0].set(title="Terminator of a sphere of 10 mm, light from the right", ylabel="radiance over the lit slope")
    axes[1].set(xlabel="mm", ylabel="difference, % of the plateau")
    axes[0].legend(frameon=False)
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.out, "sphere.png"), dpi=80)


def slabs(arguments):
    with open(os.path.join(arguments.reference, "slabs_random_walk.csv")) as file:
        rows = [line.strip().split(",") for line in file][1:]
    figure, axes = plot.subplots(figsize=(8, 4.5))
    points = [[], [], []]
    for row in rows:
        if row[:2] != ["RANDOM_WALK", "skin"] or not row[2].replace(".", "").isdigit() or float(row[2]) > 20:
            continue
        thickness = float(row[2])
        side = 200.0
        path = write_obj(os.path.join(arguments.out, "slab-%g.obj" % thickness),
                         [(x * side, y * side, z * thickness / 2) for z in (1, -1) for y in (-1, 1) for x in (-1, 1)],
                         [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)])
        look = dict(WALK, **{"specular.intensity": 0, "transmission.weight": 1, "transmission.thickness_source": "mesh",
                             "transmission.normal_scale": 0, "transmission.thickness_max_mm": 50})
        scene = {"model": {"path": path, "millimetres_per_unit": 1}, "materials": {"*": material(look)}, "environment": DARK,
                 "camera": {"position": [0, 0, 100], "target": [0, 0, 0], "orthographic_height": 10},
                 "lights": [{"type": "directional", "direction": [0, 0, 1], "intensity": float(numpy.pi)}]}
        output = os.path.join(arguments.out, "slab-%g.exr" % thickness)
        layers = render(arguments.dermis, scene, output, (16, 16), 16, ["transmission", "thickness"])
        mine = layers["transmission"][4:12, 4:12, :3].mean(axis=(0, 1))
        scene["lights"][0]["direction"] = [0, 0, -1]
        back = render(arguments.dermis, scene, output, (16, 16), 16, ["diffuse_scattered"])
        reflected = back["diffuse_scattered"][4:12, 4:12, :3].mean(axis=(0, 1))
        theirs = numpy.array([float(v) for v in row[6:9]])
        for c in range(3):
            points[c].append((thickness, mine[c], theirs[c]))
            note = " (T below 0.01 is not asked for)" if theirs[c] < 0.01 else ""
            print("slab %g mm, %s: T %.4f against %.4f, %+.1f %%%s; R %.4f against %.4f, R + T %.4f" %
                  (thickness, "RGB"[c], mine[c], theirs[c], 100 * (mine[c] / theirs[c] - 1) if theirs[c] else 0, note, reflected[c],
                   float(row[3 + c]), reflected[c] + mine[c]))
    for c in range(3):
        t, mine, theirs = numpy.array(points[c]).T
        axes.semilogy(t, mine, color=COLOURS[c], marker="o", ms=4, label="ours, %s" % "RGB"[c])
        axes.semilogy(t, theirs, color="black", ls="none", marker="x", label="random walk" if c == 2 else None)
    axes.set(title="Transmittance of slabs", xlabel="mm", ylabel="T", ylim=(1e-4, 1))
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.out, "slabs.png"), dpi=80)


def boxed(image, n=4):
    height, width = image.shape[0] // n, image.shape[1] // n
    return image[:height * n, :width * n].reshape(height, n, width, n, -1).mean(axis=(1, 3))


def head(arguments):
    """The scanned head from the front: with and without specular, against the path tracer's, where both cover the pixel."""
    scan = os.path.join(arguments.assets, "lee_perry_smith")
    # The walk's own mean free path varies with each texel; at the mean texel its edge is Burley's with these d.
    look = {"subsurface.radius_reading": "burley_d", "subsurface.radius_mm": [0.50, 0.27, 0.15], "specular.f0": 0.028,
            "specular.perceptual_roughness": 0.45, "specular.lobe_scale": [1, 1], "transmission.weight": 1}
    textures = {"albedo": {"path": os.path.join(scan, "Map-COL.jpg"), "color_space": "srgb"}}
    base = {"model": {"path": os.path.join(scan, "lps_head_sub1.glb"), "millimetres_per_unit": 1000},
            "environment": {"path": os.path.join(arguments.assets, "hdri", "blender_studio.exr"), "rotation_degrees": -90,
                            "background": "none"},
            "camera": {"position": [0, -0.023, 0.82], "target": [0, -0.023, -0.08], "vertical_fov_degrees": 20},
            "lights": [{"type": "directional", "direction": [0.5025, -0.5025, -0.7035], "intensity": 2}]}
    for name, file, intensity in (("full", "head_front_path_traced.exr", 1), ("sss only", "head_front_path_traced_sss_only.exr", 0)):
        theirs = read_exr(os.path.join(arguments.reference, file))[""]
        scene = dict(base, materials={"*": material(dict(look, **{"specular.intensity": intensity}), textures=textures)})
        output = os.path.join(arguments.out, "head-%s.exr" % name.replace(" ", "-"))
        layers = render(arguments.dermis, scene, output, (768, 768), 64,
                        ["diffuse", "diffuse_scattered", "specular", "transmission", "occlusion"])
        mine = layers[""]
        inside = (boxed(theirs[..., 3:4])[..., 0] > 0.999) & (boxed(mine[..., 3:4])[..., 0] > 0.999)
        a, b = boxed(mine[..., :3]), boxed(theirs[..., :3])
        difference = numpy.abs(a - b)[inside].mean() / b[inside].mean()
        signed = (a[inside].mean(axis=0) / b[inside].mean(axis=0))
        print("head, %s: mean absolute difference %s of the mean, after a 4×4 box; ours over theirs %s" %
              (name, percent(difference), " ".join("%.3f" % v for v in signed)))
        figure, axes = plot.subplots(1, 3, figsize=(13, 4.6))
        for axis, image, title in zip(axes, (mine[..., :3], theirs[..., :3]), ("ours", "path traced")):
            axis.imshow(numpy.clip(image, 0, 1)**(1 / 2.2))
            axis.set_title(title)
        signed_picture = numpy.where(inside[..., None], a - b, 0).mean(axis=-1)
        shown = axes[2].imshow(signed_picture, cmap="RdBu_r", vmin=-0.15, vmax=0.15)
        axes[2].set_title("ours − theirs, 4×4 box")
        figure.colorbar(shown, ax=axes[2], fraction=0.046)
        for axis in axes:
            axis.axis("off")
        figure.tight_layout()
        figure.savefig(os.path.join(arguments.out, "head-%s.png" % name.replace(" ", "-")), dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("reference")
    parser.add_argument("assets")
    parser.add_argument("out")
    parser.add_argument("--dermis", default="build/bin/dermis")
    parser.add_argument("--only", choices=("edge", "sphere", "slabs", "head"))
    arguments = parser.parse_args()
    arguments.reference, arguments.assets, arguments.out = map(os.path.abspath, (arguments.reference, arguments.assets, arguments.out))
    os.makedirs(arguments.out, exist_ok=True)
    for name, check in (("edge", edges), ("sphere", sphere), ("slabs", slabs), ("head", head)):
        if arguments.only in (None, name):
            check(arguments)


if __name__ == "__main__":
    main()
