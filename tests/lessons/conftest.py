"""A small course with every kind of exercise, and progress that stays in a folder of the test."""

from collections.abc import Iterator
from pathlib import Path

import pytest

import kinlab.lessons.answers
from kinlab.lessons import Course, load_course, registry

HERE = Path(__file__).parent


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("KINLAB_HOME", str(tmp_path / "home"))
    for name in ("KINLAB_LANG", "KINLAB_LESSONS"):
        monkeypatch.delenv(name, raising=False)
    return tmp_path / "home"


@pytest.fixture(autouse=True)
def sample_topic(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """`sample.*` for lessons that only these tests know."""
    paths = [*kinlab.lessons.answers.__path__, str(HERE / "topics")]
    monkeypatch.setattr(kinlab.lessons.answers, "__path__", paths)
    registry.topics.cache_clear()
    yield
    registry.topics.cache_clear()


@pytest.fixture
def samples(sample_topic: None) -> Course:
    """The course with the lesson `every-kind`."""
    return load_course(HERE / "course")
