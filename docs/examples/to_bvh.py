"""Turns the motion of an FBX or glTF file into BVH, with Blender:

blender --background --python to_bvh.py -- IN.fbx OUT.bvh
"""
import sys

import bpy

source, target = sys.argv[sys.argv.index("--") + 1 :][:2]
bpy.ops.wm.read_factory_settings(use_empty=True)
# Frames a second for glTF, which has times and no frames. FBX has its own rate.
bpy.context.scene.render.fps = 60
if source.lower().endswith(".fbx"):
    bpy.ops.import_scene.fbx(filepath=source, automatic_bone_orientation=True)
else:
    bpy.ops.import_scene.gltf(filepath=source)
armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
bpy.context.view_layer.objects.active = armature
first, last = map(round, armature.animation_data.action.frame_range)
# All bones keep their positions: in many rigs the root stands still and the hips below it travel. The reader
# of BVH files makes such hips the root, and positions that never change become bones of fixed length.
bpy.ops.export_anim.bvh(filepath=target, frame_start=first, frame_end=last, root_transform_only=False)
