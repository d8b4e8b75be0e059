# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Renders a glTF scene by Blender's Cycles on the processor, and prints its times as JSON.

Usage: blender --background --factory-startup --python cycles.py -- SETTINGS.json

The settings: scene, sky (its radiance), matt (whether surfaces are matt by Lambert's law), defaults
(whether Cycles clamps, blurs and skips light as it does unless told otherwise), output (EXR, or
none), width, height, samples (a list: one render each), bounces, position (in Blender's axes),
threads. The camera is the whole sphere of directions, like Balcony's `panorama`: the centre of the
picture looks along x.
"""
import json
import math
import sys
import time

import bpy
import numpy

# Blender 3.4's importer of glTF uses a name that numpy 1.24 has removed.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

# By which its importer divides the illuminance of suns, but not what surfaces emit.
LUMENS_PER_WATT = 683


def load(scene_file, sky):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=scene_file)
    scene = bpy.context.scene
    world = bpy.data.worlds.new("sky")
    world.color = (sky, sky, sky)
    scene.world = world
    for light in bpy.data.lights:
        light.energy *= LUMENS_PER_WATT
    return scene


def make_matt():
    """Gives surfaces Lambert's law: the diffuse part of the Principled BSDF is Disney's, brighter at
    grazing angles."""
    for material in bpy.data.materials:
        nodes, links = material.node_tree.nodes, material.node_tree.links
        for node in [node for node in nodes if node.type == "BSDF_PRINCIPLED"]:
            inputs = node.inputs
            emits = inputs["Emission"].is_linked or max(inputs["Emission"].default_value[:3]) > 0
            if emits or inputs["Metallic"].default_value > 0 or inputs["Transmission"].default_value > 0:
                continue
            diffuse = nodes.new("ShaderNodeBsdfDiffuse")
            diffuse.inputs["Color"].default_value = inputs["Base Color"].default_value
            for link in inputs["Base Color"].links:
                links.new(link.from_socket, diffuse.inputs["Color"])
            for link in list(node.outputs["BSDF"].links):
                links.new(diffuse.outputs["BSDF"], link.to_socket)


def add_camera(scene, position):
    camera = bpy.data.cameras.new("panorama")
    camera.type = "PANO"
    camera.cycles.panorama_type = "EQUIRECTANGULAR"
    camera.clip_start = 1e-4
    placed = bpy.data.objects.new("panorama", camera)
    placed.location = position
    placed.rotation_euler = (math.pi / 2, 0, -math.pi / 2)
    scene.collection.objects.link(placed)
    scene.camera = placed


def set_up(scene, settings):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = settings["width"]
    scene.render.resolution_y = settings["height"]
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.threads_mode = "FIXED"
    scene.render.threads = settings["threads"]
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.seed = settings["seed"]
    if not settings["defaults"]:
        cycles.sample_clamp_indirect = 0
        cycles.sample_clamp_direct = 0
        cycles.blur_glossy = 0
        cycles.light_sampling_threshold = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for limit in ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces"):
        setattr(cycles, limit, settings["bounces"])
    cycles.transparent_max_bounces = 64


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        settings = json.load(file)
    scene = load(settings["scene"], settings["sky"])
    if settings["matt"]:
        make_matt()
    add_camera(scene, settings["position"])
    set_up(scene, settings)
    seconds = []
    for samples in settings["samples"]:
        scene.cycles.samples = samples
        began = time.monotonic()
        bpy.ops.render.render(write_still=False)
        seconds.append(time.monotonic() - began)
    if settings.get("output"):
        bpy.data.images["Render Result"].save_render(settings["output"])
    print("times:", json.dumps(seconds))


main()
