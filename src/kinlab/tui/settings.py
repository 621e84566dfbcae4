"""What is kept from one run to the next: theme, language, station, and what each station was set to."""

import json
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from kinlab.errors import KinlabError
from kinlab.files import write_whole


@dataclass
class Settings:
    """What a person has chosen.

    Attributes:
        theme: name of the theme.
        language: its code; None until somebody has chosen one.
        station: the one that was open.
        stations: by station, what it keeps.
    """

    theme: str = "kinlab-dark"
    language: str | None = None
    station: str = "robot"
    stations: dict[str, dict[str, Any]] = field(default_factory=dict)

    @classmethod
    def load(cls, path: Path) -> tuple["Settings", Path | None]:
        """The settings of a file, the default ones where there is none.

        Returns:
            The settings, and where a damaged file has been set aside; None where nothing was wrong.
        """
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
            return cls(**_checked(found)), None
        except FileNotFoundError:
            return cls(), None
        except OSError:
            return cls(), None
        except (ValueError, TypeError, RecursionError):
            aside = path.with_suffix(".damaged")
            try:
                os.replace(path, aside)
            except OSError:
                return cls(), None
            return cls(), aside

    def save(self, path: Path) -> str:
        """Write the file; why it could not be written, empty where it was."""
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, json.dumps(asdict(self), indent=1, ensure_ascii=False) + "\n")
        except (OSError, KinlabError) as error:
            return str(error)
        return ""


def _checked(found: Any) -> dict[str, Any]:
    """The fields of a settings document, each of its type."""
    if not isinstance(found, dict):
        raise TypeError("settings are a table")
    stations = found.get("stations", {})
    if not isinstance(stations, dict) or not all(isinstance(kept, dict) for kept in stations.values()):
        raise TypeError("stations are tables")
    checked: dict[str, Any] = {"stations": stations}
    for name in ("theme", "language", "station"):
        value = found.get(name)
        if value is not None:
            if not isinstance(value, str):
                raise TypeError(f"{name} is a text")
            checked[name] = value
    return checked
