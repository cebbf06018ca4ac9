"""Opens a motion in Blender.

`blender.py IN.bvh PLACES.json` writes the start of each bone in each frame, in the file's units, z up.
`blender.py IN.bvh OUT.fbx` or `OUT.glb` saves the motion as another program would.
"""
import json
import sys

import bpy

source, target = sys.argv[1:3]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_anim.bvh(filepath=source, update_scene_fps=True)
scene = bpy.context.scene
armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
scene.frame_start, scene.frame_end = map(round, armature.animation_data.action.frame_range)
if target.endswith(".fbx"):
    bpy.ops.export_scene.fbx(filepath=target, add_leaf_bones=False, bake_anim_simplify_factor=0)
elif target.endswith(".glb"):
    bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_optimize_animation_size=False)
else:
    frames = []
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        bones = armature.pose.bones
        frames.append({bone.name: list(armature.matrix_world @ bone.head) for bone in bones})
    with open(target, "w") as file:
        json.dump(frames, file)
