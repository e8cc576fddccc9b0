#!/usr/bin/env python3
"""Renders the two heads that docs/validation.md describes, from a folder of assets that is not part of this project.

    tests/validation/heads.py ASSETS OUT [--dermis build/bin/dermis] [--size 900x900] [--samples 64] [--only NAME]

ASSETS holds `lee_perry_smith/`, `makehuman/` and `hdri/` as docs/validation.md lists them. Each picture's scene is
written beside it, so that it can be opened in the editor. Standard library only.
"""
import argparse
import json
import os
import subprocess
import sys


PRESETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "presets")


def material(model, parameters, textures):
    return {"format": "dermis.material", "version": 1, "model": model, "parameters": parameters, "textures": textures}


def scenes(assets):
    """Every picture by name: a scene whose paths lead into the assets folder."""
    lps = os.path.join(assets, "lee_perry_smith")
    makehuman = os.path.join(assets, "makehuman")
    hdri = os.path.join(assets, "hdri")

    scan_maps = {
        "albedo": {"path": os.path.join(lps, "Map-COL.jpg"), "color_space": "srgb"},
        "normal": {"path": os.path.join(lps, "Infinite-Level_02_Tangent_SmoothUV.jpg")},
        "specular": {"path": os.path.join(lps, "Map-SPEC.jpg")},
    }
    scan_looks = {
        "thesis": material("thesis", {"specular.perceptual_roughness": 0.45, "base.metallic": 0}, scan_maps),
        "skin": material("skin", {}, scan_maps),
        "metallic_roughness": material("metallic_roughness", {"specular.perceptual_roughness": 0.5, "base.metallic": 0},
                                       {k: v for k, v in scan_maps.items() if k != "specular"}),
    }
    scan_model = {"path": os.path.join(lps, "lps_head_sub1.glb"), "millimetres_per_unit": 1000}
    scan_camera = {"position": [0.16, 0.0, 0.86], "target": [0, -0.025, 0], "up": [0, 1, 0], "vertical_fov_degrees": 24}
    key = {"type": "point", "position": [-0.6, 0.5, 0.9], "color": [1, 0.96, 0.9], "intensity": 1.2, "shadow": False}

    result = {}
    for model, look in scan_looks.items():
        result["scan-" + model] = {
            "model": scan_model, "materials": {"*": look}, "lights": [key] if model == "thesis" else [],
            "environment": {"path": os.path.join(hdri, "studio_small_09_1k.hdr"), "background": "prefiltered:0.4"},
            "camera": scan_camera, "view": {"transform": "Thesis" if model == "thesis" else "ACES"}}

    # What docs/benchmarks.md measures: four shadowed lamps in front.
    four = [{"type": "point", "position": position} for position in
            ([-0.6, 0.5, 0.9], [0.6, 0.5, 0.9], [0, 0.8, 0.5], [0.5, -0.3, 0.8])]
    for model in ("skin", "thesis"):
        result["moving-" + model] = {
            "model": scan_model, "materials": {"*": scan_looks[model]}, "lights": four, "camera": scan_camera,
            "environment": {"path": os.path.join(hdri, "studio_small_09_1k.hdr")},
            "view": {"transform": "Thesis" if model == "thesis" else "ACES"}}

    # Light under the skin: a key with its terminator on the cheek, light from behind, the environment alone, lengths × 0.1 and × 10.
    sphere_key = {"type": "sphere", "position": [-0.7, 0.35, 0.55], "color": [1, 0.96, 0.9], "intensity": 1.6, "radius_mm": 60}
    behind = {"type": "spot", "position": [0.35, 0.1, -0.6], "direction": [-0.5, -0.15, 0.85], "intensity": 2.5,
              "inner_degrees": 25, "outer_degrees": 40}
    ear_camera = {"position": [0.42, 0.03, 0.55], "target": [0.075, -0.005, -0.03], "up": [0, 1, 0], "vertical_fov_degrees": 9}
    dim = {"constant": [0.02, 0.02, 0.022], "background": "color:0.02,0.02,0.022"}
    studio = {"path": os.path.join(hdri, "studio_small_09_1k.hdr"), "background": "prefiltered:0.4"}

    def scan(name, parameters=None, **scene):
        base = {"model": scan_model, "materials": {"*": material("skin", parameters or {}, scan_maps)}, "camera": scan_camera,
                "view": {"transform": "ACES"}, "environment": dim}
        result["scan-" + name] = {**base, **scene}

    scan("key", lights=[sphere_key])
    scan("backlit", lights=[behind])
    scan("backlit-ear", lights=[behind], camera=ear_camera)
    scan("environment", environment=studio)
    for factor in (0.1, 1, 10):
        scan("scale-x%g" % factor, {"subsurface.scale": factor}, lights=[sphere_key])
    # The tones colour the whole head evenly: the scan's own albedo is one person's.
    for tone in ("i", "ii", "iii", "iv", "v", "vi"):
        result["scan-tone-" + tone] = {
            "model": scan_model, "materials": {"*": os.path.join(PRESETS, "skin_tone_%s.json" % tone)}, "camera": scan_camera,
            "view": {"transform": "ACES"}, "environment": studio, "lights": [sphere_key]}

    eye_map = {"albedo": {"path": os.path.join(makehuman, "textures", "eye_brown_albedo.png"), "color_space": "srgb"}}
    face_maps = {"albedo": {"path": os.path.join(makehuman, "textures", "skin_light_albedo.png"), "color_space": "srgb"},
                 "occlusion": {"path": os.path.join(makehuman, "textures", "head_a_ao.png")}}
    second_head = {
        "skin": material("skin", {"specular.perceptual_roughness": 0.4}, face_maps),
        "eye": material("eye", {"specular.perceptual_roughness": 0.08}, eye_map),
        "lens": material("lens", {"lens.opacity": 0.0}, {}),
    }
    folder = os.path.join(makehuman, "head_a")
    parts = {"parts": [{"path": os.path.join(folder, name)} for name in ("face.obj", "eye.obj", "lens.obj")],
             "millimetres_per_unit": 1000}
    for name in ("lebombo_1k.hdr", "blender_studio.exr"):
        result["head-a-" + name.split(".")[0]] = {
            "model": parts, "materials": second_head,
            "environment": {"path": os.path.join(hdri, name), "rotation_degrees": 180 if "lebombo" in name else 0},
            "camera": {"position": [0.1, 0.0, 0.75], "target": [0, -0.02, -0.03], "vertical_fov_degrees": 24}}
    return {name: {"format": "dermis.scene", "version": 1, **scene} for name, scene in result.items()}


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("assets")
    arguments.add_argument("out")
    arguments.add_argument("--dermis", default="build/bin/dermis")
    arguments.add_argument("--size", default="900x900")
    arguments.add_argument("--samples", default="64")
    arguments.add_argument("--only", default="")
    given = arguments.parse_args()
    os.makedirs(given.out, exist_ok=True)
    failed = 0
    for name, scene in scenes(os.path.abspath(given.assets)).items():
        if given.only not in name:
            continue
        path = os.path.join(given.out, name + ".dermis")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(scene, file, indent=2)
        picture = os.path.join(given.out, name + ".png")
        command = [given.dermis, "render", path, "--size", given.size, "--samples", given.samples, "-o", picture]
        print(name, flush=True)
        failed += subprocess.run(command, check=False).returncode != 0
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
