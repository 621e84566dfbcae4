"""What is shown of a robot in 3-D: recordings for rerun, the only room that imports it.

from kinlab.scene import gait_scene, save
save(gait_scene(walk), Path("walk.rrd"))

Lengths are in millimetres, angles in degrees, as everywhere that people look. Timelines: `time`, simulated and
from the beginning, and `phase`, in thousandths of a gait cycle.
"""

from kinlab.scene.arm import arm_scene
from kinlab.scene.gait import check_recordable, gait_scene, walk_scene
from kinlab.scene.leg import robot_scene, target_scene
from kinlab.scene.mirror import Mirror
from kinlab.scene.recording import Recording, load_rerun
from kinlab.scene.saving import check_new, check_recording, save
from kinlab.scene.viewer import View, check_viewer, viewing

__all__ = [
    "Mirror",
    "Recording",
    "View",
    "arm_scene",
    "check_new",
    "check_recordable",
    "check_recording",
    "check_viewer",
    "gait_scene",
    "load_rerun",
    "robot_scene",
    "save",
    "target_scene",
    "viewing",
    "walk_scene",
]
