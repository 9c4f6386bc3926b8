#!/usr/bin/env python3
"""tools/mitsuba_scene says the same as the scene that it reads, or in one line why it cannot."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "tools/mitsuba_scene"
GREY = '<bsdf type="diffuse" id="grey"><rgb name="reflectance" value="0.5"/></bsdf>'
BALL = '<shape type="sphere" id="ball"><point name="center" x="1" y="2" z="3"/><float name="radius" value="2"/><ref id="grey"/></shape>'


def scene_text(shapes=GREY + BALL, integrator='<integer name="max_depth" value="5"/>', sensor='<float name="fov" value="60"/>'):
    return f"""<scene version="3.0.0"><integrator type="path">{integrator}</integrator>
        <sensor type="perspective">{sensor}<film type="hdrfilm"><integer name="width" value="200"/><integer name="height" value="100"/></film>
        </sensor>{shapes}</scene>"""


def sphere(inside):
    return f'{GREY}<shape type="sphere">{inside}<ref id="grey"/></shape>'


def with_metal(inside):
    return f'<shape type="sphere"><bsdf type="conductor">{inside}</bsdf></shape>'


def matrix(values):
    return f'<transform name="to_world"><matrix value="{values}"/></transform>'


class MitsubaScene(unittest.TestCase):
    def run_program(self, text):
        with tempfile.TemporaryDirectory() as folder:
            read, written = pathlib.Path(folder) / "in.xml", pathlib.Path(folder) / "out.json"
            read.write_text(text)
            run = subprocess.run([sys.executable, PROGRAM, read, written], capture_output=True, text=True)
            return run, json.loads(written.read_text()) if written.exists() else None

    def scene(self, **parts):
        run, scene = self.run_program(scene_text(**parts))
        self.assertEqual(run.returncode, 0, run.stderr)
        return scene

    def refusal(self, **parts):
        run, scene = self.run_program(scene_text(**parts))
        self.assertIsNone(scene)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        return run.stderr

    def test_spheres_are_where_their_transform_puts_them(self):
        self.assertEqual(self.scene()["objects"][0], {"type": "sphere", "material": "grey", "center": [1, 2, 3], "radius": 2})
        moved = self.scene(shapes=sphere('<float name="radius" value="0.5"/>' + matrix("0 2 0 1 -2 0 0 2 0 0 2 3 0 0 0 1")))["objects"][0]
        self.assertEqual((moved["center"], moved["radius"]), ([1, 2, 3], 1))
        both = self.scene(shapes=sphere('<point name="center" value="1, 0, 0"/>' + matrix("0 2 0 1 -2 0 0 2 0 0 2 3 0 0 0 1")))["objects"][0]
        self.assertEqual((both["center"], both["radius"]), ([1, 0, 3], 2))
        self.assertIn("ellipsoid", self.refusal(shapes=sphere(matrix("1 0 0 0 0 2 0 0 0 0 1 0 0 0 0 1"))))
        self.assertIn("one matrix", self.refusal(shapes=sphere('<transform name="to_world"><scale value="2"/></transform>')))
        self.assertIn("flip_normals", self.refusal(shapes=sphere('<boolean name="flip_normals" value="true"/>')))

    def test_disks_keep_their_front_in_a_mirror(self):
        disk = lambda values: self.scene(shapes=f'{GREY}<shape type="disk">{matrix(values)}<ref id="grey"/></shape>')["objects"][0]
        turned = disk("0 0 5 1 2 0 0 2 0 2 0 3 0 0 0 1")
        self.assertEqual(turned, {"type": "disk", "material": "grey", "center": [1, 2, 3], "normal": [1, 0, 0], "radius": 2})
        self.assertEqual(disk("0 2 0 1 2 0 0 2 0 0 1 3 0 0 0 1")["normal"], [0, 0, 1])
        oval = f'{GREY}<shape type="disk">{matrix("2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")}<ref id="grey"/></shape>'
        self.assertIn("an ellipse", self.refusal(shapes=oval))

    def test_metals_have_an_index_or_a_name(self):
        metal = lambda inside: next(iter(self.scene(shapes=with_metal(inside))["materials"]))
        self.assertEqual(metal('<string name="material" value="Au"/>')["metal"], "gold")
        self.assertEqual(metal("")["metal"], "copper")
        perfect = metal('<string name="material" value="none"/>')
        self.assertEqual((perfect["eta"], perfect["k"]), (0, 1))
        self.assertEqual(metal('<rgb name="eta" value="1, 2, 3"/><rgb name="k" value="4"/>')["eta"], [1, 2, 3])
        self.assertIn('"Hg"', self.refusal(shapes=with_metal('<string name="material" value="Hg"/>')))
        self.assertIn('no "k"', self.refusal(shapes=with_metal('<rgb name="eta" value="1"/>')))
        spectrum = '<spectrum name="eta" value="400:1"/><rgb name="k" value="4"/>'
        self.assertIn("neither a number nor a colour", self.refusal(shapes=with_metal(spectrum)))

    def test_shapes_refer_to_a_material_or_have_their_own(self):
        scene = self.scene(shapes=with_metal("") + '<shape type="sphere"/>' + GREY + BALL)
        self.assertEqual([material["type"] for material in scene["materials"]], ["conductor", "diffuse", "diffuse"])
        self.assertEqual([thing["material"] for thing in scene["objects"]], [material["name"] for material in scene["materials"]])
        self.assertIn('there is no bsdf "grey"', self.refusal(shapes=BALL))
        for kind in ("principled", "roughdiffuse"):
            self.assertIn("no counterpart for bsdf", self.refusal(shapes=f'<bsdf type="{kind}" id="a"/>'))
        self.assertIn('"water"', self.refusal(shapes='<bsdf type="dielectric" id="a"><string name="int_ior" value="water"/></bsdf>'))
        self.assertIn("texture", self.refusal(shapes='<bsdf type="diffuse" id="a"><texture type="bitmap" name="reflectance"/></bsdf>'))

    def test_depth_counts_surfaces(self):
        depth = lambda value: self.scene(integrator=f'<integer name="max_depth" value="{value}"/>')["integrator"]["max_depth"]
        self.assertEqual(depth(5), 4)
        self.assertEqual(depth(-1), 1000)
        self.assertEqual(self.scene(integrator="")["integrator"]["max_depth"], 1000)
        self.assertIn("max_depth 1", self.refusal(integrator='<integer name="max_depth" value="1"/>'))
        self.assertIn("hide_emitters", self.refusal(integrator='<boolean name="hide_emitters" value="true"/>'))

    def test_the_angle_of_view_is_that_of_its_axis(self):
        def tangent(axis):
            sensor = '<float name="fov" value="60"/>' + (f'<string name="fov_axis" value="{axis}"/>' if axis else "")
            return math.tan(math.radians(self.scene(sensor=sensor)["camera"]["fov"] / 2)) / math.tan(math.radians(30))

        expected = {"": 0.5, "x": 0.5, "y": 1, "smaller": 1, "larger": 0.5, "diagonal": 1 / math.sqrt(5)}
        for axis, ratio in expected.items():
            self.assertAlmostEqual(tangent(axis), ratio, msg=axis)
        self.assertIn('fov_axis "z"', self.refusal(sensor='<float name="fov" value="60"/><string name="fov_axis" value="z"/>'))
        self.assertIn('no "fov"', self.refusal(sensor=""))


if __name__ == "__main__":
    unittest.main()
