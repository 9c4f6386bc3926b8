#!/usr/bin/python3
"""The schema is valid, accepts every example, and refuses each of the broken variants below."""
import copy
import json
import pathlib
import sys

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = {
    "camera": {"from": [0, 0, 5], "at": [0, 0, 0]},
    "materials": [{"name": "grey", "type": "whitted"}],
    "lights": [{"type": "point", "position": [0, 5, 0], "intensity": 10}],
    "groups": [{"name": "g", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]}],
    "objects": [
        {"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1},
        {"type": "instance", "group": "g", "material": "grey", "transform": [
            {"scale": -2}, {"scale": [1, 2, -3]}, {"rotate": 30, "axis": [0, 1, 0]}, {"translate": [1, 2, 3]}, {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]}]},
    ],
}
MISSING = object()
BROKEN = {
    "/film": [{"width": 0}, {"height": 65536}, {"spp": 0}, {"spp": 1.5}, {"seed": -1}, {"pixel": "middle"}, {"filter": "sinc"}, {"filter_radius": 0}, {"filter_radius": 101}, {"aovs": ["colour"]}, {"aovs": "normal"}, {"crop": [1, 2, 3]}, {"crop": [0, -1, 2, 2]}, {"tone": "film"}, {"exposure": "manual"}, {"exposure": 101}, {"exposure": -101}, {"widht": 3}, []],
    "/integrator": [{"type": "radiosity"}, {"max_depth": 0}, {"max_depth": 1001}, {"threshold": -1}, {"light_samples": -1}, {"light_samples": 65}, {"shadows": "soft"}, {"bundles": 4}, {"bundles": {"light": 0}}, {"bundles": {"diffuse": 1025}}, {"bundles": {"glossy": 1.5}}, {"bundles": {"mirror": 2}}],
    "/accelerator": ["octopus", 3],
    "/background": [-1, [1, 2], "blue", 1e39, [0, 0, -1], {}, {"image": 3}, {"image": "a.hdr", "rotate": "x"}, {"image": "a.hdr", "wrap": "clamp"}, {"image": "a.hdr", "scale": -1}],
    "/cameras": [[SCENE["camera"]], []],
    "/camera/fov": [0, 180, "wide"],
    "/camera/type": ["pinhole", "orthographic", "thin_lens"],
    "/camera": [
        MISSING, {}, {"from": [0, 0, 5]},
        {"type": "orthographic", "from": [0, 0, 5], "at": [0, 0, 0], "height": 0},
        {"type": "orthographic", "from": [0, 0, 5], "at": [0, 0, 0], "height": 2, "fov": 30},
        {"type": "thin_lens", "from": [0, 0, 5], "at": [0, 0, 0], "focus_distance": 2},
        {"type": "thin_lens", "from": [0, 0, 5], "at": [0, 0, 0], "lens_radius": 0.1, "focus_distance": 2, "focus_at": [0, 0, 0]},
        {"type": "thin_lens", "from": [0, 0, 5], "at": [0, 0, 0], "lens_radius": 0.1, "focus_distance": 2, "blades": 2},
        {"type": "panorama", "from": [0, 0, 5], "at": [0, 0, 0], "fov": 181},
        {"type": "panorama", "from": [0, 0, 5], "at": [0, 0, 0], "horizontal_fov": 361},
        {"type": "fisheye", "from": [0, 0, 5], "at": [0, 0, 0], "fov": 361},
        {"type": "fisheye", "from": [0, 0, 5], "at": [0, 0, 0], "mapping": "stereographic"},
    ],
    "/camera/inside": ["water", [1]],
    "/camera/shutter": [1, [0], [0, "x"], [0, 1, 2]],
    "/camera/keys": [{}, [{"time": 0}], [{"time": 0}, {"from": [0, 0, 5]}], [{"time": 0}, {"time": 1, "fov": 30}]],
    "/materials/0/name": [MISSING, "", 7],
    "/materials/0/type": [MISSING, "velvet"],
    "/materials/0/diffuse": [-0.1, [1, 1], None, {}, {"texture": 3}, {"texture": "a.png", "wrap": "mirror"}, {"texture": "a.png", "encoding": "gamma"}, {"image": "a.png"}],
    "/materials/0/specular": [{"texture": "a.png", "scale": -1}],
    "/materials/0/ambient": [{"texture": "a.png"}],
    "/materials/0/exponent": [0],
    "/materials/0/reflection": [1.1, [0, 0, 2]],
    "/materials/0/eta": [0],
    "/materials/0/fresnel": [1],
    "/materials/0/priority": [-1, 16777217, 0.5],
    "/materials/0/emission_side": ["inside", 1],
    "/materials/0/colour": [1],
    "/lights/0/type": [MISSING, "directional", "sun"],
    "/lights/0/intensity": [MISSING, -1],
    "/lights/0/attenuation": [[0, 0, 0], [0, 0, -1], [1]],
    "/lights/0": [
        {"type": "directional", "direction": [0, 0, 0], "irradiance": 1},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "at": [0, 0, 0], "direction": [0, 0, 1]},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "direction": [0, 0, 0]},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "at": [0, 0, 0], "angle": 361},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "at": [0, 0, 0], "angle": 0},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "at": [0, 0, 0], "penumbra": 1.1},
        {"type": "spot", "position": [0, 5, 0], "intensity": 1, "at": [0, 0, 0], "attenuation": [0, 0, 0]},
    ],
    "/objects/0/type": [MISSING, "cube", "cylinder"],
    "/objects/0/material": [MISSING, 3],
    "/objects/0/radius": [MISSING, -1, 1e16],
    "/objects/0/center": [[0, 0], [0, 0, 1e16], [0, 0, "x"]],
    "/objects/0/apex": [[0, 0, 0]],
    "/objects/0": [
        {"type": "triangle_mesh", "material": "grey", "positions": [[0, 0, 0]], "indices": [0, 0, -1]},
        {"type": "triangle_mesh", "material": "grey", "positions": [[0, 0, 0]], "indices": [0, 0, 0], "uvs": [[1]]},
        {"type": "triangle_mesh", "material": "grey", "positions": [[0, 0, 0]], "indices": [0, 0, 0], "colors": [[1, 0, -1]]},
        {"type": "polygon", "material": "grey", "vertices": [[0, 0, 0], [1, 0, 0]]},
        {"type": "mesh"},
        {"type": "mesh", "file": ""},
        {"type": "mesh", "file": "bunny.obj", "material": 1},
    ],
    "/objects/1": [
        {"type": "instance"}, {"type": "instance", "group": 3}, {"type": "instance", "group": "g", "material": 1},
        {"type": "instance", "group": "g", "transform": 3}, {"type": "instance", "group": "g", "radius": 1},
    ],
    "/objects/1/transform": [
        [{"time": 0}], [{"time": 0}, {"scale": 2}], [{"time": 0}, {"time": 1, "transform": [{"time": 2}]}], [{"time": 0}, {"time": "late"}],
        {}, [{}], {"scale": 0}, {"scale": [1, 0, 1]}, {"scale": 2, "translate": [0, 0, 1]}, {"rotate": 3}, {"scale": 2, "axis": [0, 0, 1]},
        {"rotate": 3, "axis": [0, 0, 0]}, {"matrix": [1, 2, 3]}, {"translate": 3}, {"skew": 1},
    ],
    "/groups/0": [{}, {"name": "g"}, {"objects": []}, {"name": "", "objects": []}, {"name": "g", "objects": [{"type": "instance", "group": "g"}]}],
    "/sphere": [{}],
}


def changed(scene, pointer, value):
    """A copy of `scene` with another value at `pointer`, or none."""
    result = copy.deepcopy(scene)
    *way, last = pointer.split("/")[1:]
    parent = result
    for step in way:
        parent = parent[int(step) if isinstance(parent, list) else step]
    last = int(last) if isinstance(parent, list) else last
    if value is MISSING:
        del parent[last]
    else:
        parent[last] = value
    return result


def main():
    schema = json.loads((ROOT / "scene/formats/brandung.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    failures = [f"the small scene: {error.message}" for error in validator.iter_errors(SCENE)]

    examples = sorted((ROOT / "scene/examples").glob("*.json"))
    for example in examples:
        scene = json.loads(example.read_text(encoding="utf-8"))
        if (example.parent / scene["$schema"]).resolve() != ROOT / "scene/formats/brandung.schema.json":
            failures.append(f"{example.name}: $schema does not lead to the schema")
        failures += [f"{example.name}: {error.json_path}: {error.message}" for error in validator.iter_errors(scene)]

    variants = [(pointer, value) for pointer, values in BROKEN.items() for value in values]
    for pointer, value in variants:
        if validator.is_valid(changed(SCENE, pointer, value)):
            failures.append(f"accepted: {pointer} = {'nothing' if value is MISSING else json.dumps(value)}")

    print("\n".join(failures + [f"{len(examples)} examples, {len(variants)} broken variants, {len(failures)} failures"]))
    return 1 if failures or not examples else 0


if __name__ == "__main__":
    sys.exit(main())
