"""What the validation scripts share: rendering with the program, and reading what it wrote. Needs numpy and oiiotool."""
import json
import os
import struct
import subprocess
import tempfile

import numpy


def material(parameters, model="skin", textures=None):
    return {"format": "dermis.material", "version": 1, "model": model, "parameters": parameters, "textures": textures or {}}


def render(dermis, scene, output, size, samples=64, aovs=(), subject=None):
    """Writes the scene beside the picture (an EXR, scene-linear) and renders it; the layers as by read_exr."""
    path = os.path.splitext(output)[0] + ".dermis"
    with open(path, "w") as file:
        json.dump(dict({"format": "dermis.scene", "version": 1}, **scene), file, indent=1)
    command = [dermis, "render", path, "--size", "%dx%d" % size, "--samples", str(samples), "--view", "raw", "-o", output]
    for aov in aovs:
        command += ["--aov", aov]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit("%s: %s" % (subject or output, done.stderr.strip()))
    return read_exr(output)


def read_exr(path):
    """{layer: float array height × width × channels}, "" the picture; any EXR that oiiotool reads."""
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "plain.exr")
        subprocess.run(["oiiotool", path, "-d", "float", "--compression", "none", "--scanline", "-o", plain], check=True,
                       capture_output=True)
        with open(plain, "rb") as file:
            data = file.read()
    at, position = {}, 8

    def text(start):
        end = data.index(0, start)
        return data[start:end].decode(), end + 1

    while data[position]:
        name, position = text(position)
        _, position = text(position)
        length, = struct.unpack_from("<i", data, position)
        at[name] = data[position + 4:position + 4 + length]
        position += 4 + length
    x0, y0, x1, y1 = struct.unpack("<4i", at["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    names, i = [], 0
    while at["channels"][i]:
        end = at["channels"].index(0, i)
        names.append(at["channels"][i:end].decode())
        i = end + 17
    planes = numpy.zeros((len(names), height, width), numpy.float32)
    for offset in struct.unpack_from("<%dQ" % height, data, position + 1):
        y, = struct.unpack_from("<i", data, offset)
        row = numpy.frombuffer(data, "<f4", len(names) * width, offset + 8)
        planes[:, y - y0, :] = row.reshape(len(names), width)
    layers = {}
    for name, plane in zip(names, planes):
        layer, _, channel = name.rpartition(".")
        layers.setdefault(layer, {})[channel] = plane
    order = "RGBAXYZ"
    return {layer: numpy.stack([channels[c] for c in sorted(channels, key=lambda c: order.find(c))], axis=-1)
            for layer, channels in layers.items()}


def read_csv(path):
    """Column name → array, of a table of numbers."""
    with open(path) as file:
        names = file.readline().strip().split(",")
        rows = [line.strip().split(",") for line in file if line.strip()]
    return {name: numpy.array([float(row[i]) for row in rows]) for i, name in enumerate(names)}


def write_obj(path, vertices, faces):
    """A mesh of flat faces, indices from 1, as OBJ with their normals: without any a box would be shaded as if it were round."""
    points = numpy.array(vertices, float)
    with open(path, "w") as file:
        for vertex in vertices:
            file.write("v %.9g %.9g %.9g\n" % tuple(vertex))
        for face in faces:
            a, b, c = (points[i - 1] for i in face[:3])
            normal = numpy.cross(b - a, c - a)
            file.write("vn %.9g %.9g %.9g\n" % tuple(normal / numpy.linalg.norm(normal)))
        for number, face in enumerate(faces, 1):
            file.write("f " + " ".join("%d//%d" % (i, number) for i in face) + "\n")
    return path
