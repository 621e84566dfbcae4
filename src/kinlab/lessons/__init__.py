"""Lessons: a course that checks itself, in English and Bahasa Indonesia.

from kinlab.lessons import Progress, Sitting, load_course

course = load_course()
sitting = Sitting(course.lesson("leg-geometry"), Progress("ani"), "en")
sitting.check("distance", "98.3 mm").message
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinlab.lessons.course import Course, load_course
    from kinlab.lessons.lesson import Figure, Lesson, LessonError
    from kinlab.lessons.progress import Progress, Standing
    from kinlab.lessons.sitting import Hint, Sitting, Text
    from kinlab.lessons.task import Task, Verdict

_HOME = {
    "Course": "course", "load_course": "course",
    "Figure": "lesson", "Lesson": "lesson", "LessonError": "lesson",
    "Progress": "progress", "Standing": "progress",
    "Hint": "sitting", "Sitting": "sitting", "Text": "sitting",
    "Task": "task", "Verdict": "task",
}  # fmt: skip

__all__ = [
    "Course",
    "Figure",
    "Hint",
    "Lesson",
    "LessonError",
    "Progress",
    "Sitting",
    "Standing",
    "Task",
    "Text",
    "Verdict",
    "load_course",
]


def __getattr__(name: str) -> Any:
    """Import on first use: a list of lessons needs no numpy."""
    if name not in _HOME:
        raise AttributeError(f"module 'kinlab.lessons' has no attribute '{name}'")
    return getattr(import_module(f"kinlab.lessons.{_HOME[name]}"), name)
