"""Every run draws the same examples: a test that fails here fails everywhere."""

from hypothesis import settings

settings.register_profile("kinlab", derandomize=True, deadline=None)
settings.load_profile("kinlab")
