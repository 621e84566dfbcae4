"""Recordings read back with rerun's own reader."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kinlab.scene import Recording, save


class ReadBack:
    """What a file holds: by entity and component, its times (s, phase in thousandths) and values, row by row."""

    def __init__(self, path: Path) -> None:
        from rerun.chunk import RrdReader

        reader = RrdReader(path)
        self.path = path
        (blueprint,) = reader.blueprints()
        # How it opens: by component, what the blueprint says, whichever view it is said of.
        self.opens: dict[str, list[Any]] = {}
        for chunk in reader.stream(store=blueprint):
            batch = chunk.to_record_batch()
            for name in (name for name in batch.schema.names if ":" in name):
                self.opens.setdefault(name, []).extend(row for row in batch[name].to_pylist() if row)
        self.columns: dict[str, dict[str, list[tuple[float | None, int | None, Any]]]] = {}
        self.timelines: set[str] = set()
        for chunk in reader.stream():
            batch = chunk.to_record_batch()
            # rerun counts nanoseconds, which Python's own durations do not hold.
            table = {
                name: (column.cast("int64") if name == "time" else column).to_pylist()
                for name, column in zip(batch.schema.names, batch.columns, strict=True)
            }
            self.timelines |= set(chunk.timeline_names)
            for name, values in table.items():
                if ":" not in name:
                    continue
                times = table.get("time") or [None] * len(values)
                phases = table.get("phase") or [None] * len(values)
                entity = self.columns.setdefault(chunk.entity_path, {})
                rows = entity.setdefault(name.split(":")[1], [])
                seconds = [None if t is None else t / 1e9 for t in times]
                rows += [row for row in zip(seconds, phases, values, strict=True) if row[2] is not None]
        for entity in self.columns.values():
            for rows in entity.values():
                rows.sort(key=lambda row: -np.inf if row[0] is None else row[0])

    def times(self, entity: str, component: str) -> np.ndarray:
        """When its rows are, s."""
        return np.array([t for t, _, _ in self.columns[entity][component]])

    def values(self, entity: str, component: str) -> list[Any]:
        """Its rows."""
        return [value for _, _, value in self.columns[entity][component]]

    def transform(self, entity: str) -> np.ndarray:
        """Its own transforms (F, 4, 4), or (1, 4, 4) where it stands still, mm."""
        if "translation" not in self.columns.get(entity, {}):
            return np.eye(4)[None]
        place = np.array(self.values(entity, "translation"))[:, 0]
        x, y, z, w = np.array(self.values(entity, "quaternion"))[:, 0].T
        T = np.zeros((len(place), 4, 4))
        T[:, 3, 3], T[:, :3, 3] = 1, place
        T[:, :3, :3] = np.moveaxis(
            np.array([
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]),
            -1, 0,
        )  # fmt: skip
        return T

    def pose(self, entity: str) -> np.ndarray:
        """Its pose in the world (F, 4, 4), mm: the product of all transforms above it."""
        T = np.eye(4)[None]
        parts = entity.strip("/").split("/")
        for i in range(1, len(parts) + 1):
            T = T @ self.transform("/" + "/".join(parts[:i]))
        return T


@pytest.fixture
def read_back(tmp_path) -> Callable[[Recording], ReadBack]:
    """Save a recording and read it."""

    def read(recording: Recording) -> ReadBack:
        save(recording, path := tmp_path / "scene.rrd", force=True)
        return ReadBack(path)

    return read


@pytest.fixture
def read_file() -> type[ReadBack]:
    """Read a file that somebody else wrote."""
    return ReadBack
