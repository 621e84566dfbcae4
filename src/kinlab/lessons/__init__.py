"""Lessons: a course that checks itself, in English and Bahasa Indonesia."""
