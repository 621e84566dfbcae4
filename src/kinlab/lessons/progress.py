"""What a student has done: a list of events that only grows, in one file for each profile.

Every change is written beside the file, forced to the disk and put in its place in one step, while a lock
keeps a second window out: a kill at any moment leaves the file with the event or without it, never half.
A file that is damaged is set aside, and what can be read of it goes on in a new one.
"""

import json
import re
import secrets
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from itertools import count
from pathlib import Path
from typing import Any

from kinlab.errors import FileError, UsageError
from kinlab.files import locked, own_folder, write_whole

FORMAT = 1
PROFILE = "student"
ENDING = ".jsonl"
EVENTS = ("try", "hint", "shown", "reset")
TRIES_BEFORE_SOLUTION = 3
ELSEWHERE = "$KINLAB_HOME can name another folder for the progress"
_SEED = re.compile(r'"seed": "([^"\\\ufffd]{1,64})"')
# In bytes: a file's name has at most 255, and that of a damaged one is longer.
_LONGEST_NAME = 192
_NAME = re.compile(r"\w[\w.@-]{0,63}")


@dataclass(frozen=True)
class Event:
    """Something that a student did.

    Attributes:
        at: when, UTC, ISO 8601.
        event: "try", "hint", "shown" (the solution was looked at) or "reset".
        lesson, version: which; the version decides the numbers.
        exercise: "" for a whole lesson.
        reply: as it was typed.
        ok, code: the verdict of a try.
    """

    at: str
    event: str
    lesson: str
    version: int
    exercise: str = ""
    reply: str = ""
    ok: bool = False
    code: str = ""

    @classmethod
    def now(cls, event: str, lesson: str, version: int, exercise: str = "", **more: Any) -> "Event":
        """Of this moment."""
        return cls(datetime.now(UTC).isoformat(timespec="seconds"), event, lesson, version, exercise, **more)

    @classmethod
    def read(cls, data: Any) -> "Event":
        """From JSON.

        Raises:
            ValueError: it is none.
        """
        fields = cls.__dataclass_fields__
        if not isinstance(data, dict) or data.get("event") not in EVENTS:
            raise ValueError("no event")
        kept = {name: data[name] for name in fields if name in data}
        kinds: dict[str, type] = {"version": int, "ok": bool}
        if not {"at", "lesson", "version"} <= kept.keys() or any(
            type(value) is not kinds.get(name, str) for name, value in kept.items()
        ):
            raise ValueError("no event")
        # JSON can name halves of characters, which no file and no terminal takes.
        "".join(map(str, kept.values())).encode()
        return cls(**kept)


@dataclass(frozen=True)
class Standing:
    """How a student stands with one exercise.

    Attributes:
        tries: counted replies, up to the right one.
        hints: how many were looked at.
        solved: whether a right reply was given.
        shown: whether the solution was looked at before.
    """

    tries: int = 0
    hints: int = 0
    solved: bool = False
    shown: bool = False

    @property
    def status(self) -> str:
        """ "solved", "shown" (with the solution's help, or not at all) or "open"."""
        return "shown" if self.shown else "solved" if self.solved else "open"

    @property
    def done(self) -> bool:
        """Whether the student may go on."""
        return self.solved or self.shown

    @property
    def may_see_solution(self) -> bool:
        """Whether enough was tried, or nothing is left to try."""
        return self.done or self.tries >= TRIES_BEFORE_SOLUTION


def standing(events: Iterable[Event], lesson: str, version: int, exercise: str) -> Standing:
    """How a student stands with an exercise, by the events since its last reset."""
    tries = hints = 0
    solved = shown = False
    for event in events:
        if event.lesson != lesson or event.version != version or event.exercise not in ("", exercise):
            continue
        if event.event == "reset":
            tries = hints = 0
            solved = shown = False
        elif event.exercise != exercise:
            continue
        elif event.event == "try" and not solved:
            tries += 1
            solved = event.ok
        elif event.event == "hint":
            hints += 1
        elif event.event == "shown":
            shown = shown or not solved
    return Standing(tries, hints, solved, shown)


class Progress:
    """The events of one profile.

    Attributes:
        profile: its name.
        seed: decides the student's numbers: the profile's name, or a random one for the profile without a name.
        events: in their order.
        path: of the file.
        set_aside: where a damaged file was put; None where it was sound.
    """

    def __init__(self, profile: str = PROFILE, folder: Path | None = None) -> None:
        """Read the profile's file, if there is one.

        Args:
            profile: its name.
            folder: of all profiles; None: `progress_folder`.

        Raises:
            UsageError: no name for a profile.
            FileError: the file is there and cannot be read.
        """
        if not _NAME.fullmatch(profile) or len(profile.casefold().encode()) > _LONGEST_NAME:
            raise UsageError(
                f"'{profile[:70]}' is no name for a profile: letters, digits and . _ @ -, at most 64"
            )
        self.profile = profile
        self.path = (folder or progress_folder()) / f"{profile.casefold()}{ENDING}"
        self.seed = ""
        self.events: list[Event] = []
        self.set_aside: Path | None = None
        self._raw = b""
        self.refresh()

    def refresh(self) -> None:
        """Take in what another window has added."""
        # Reading needs no lock: a file is whole at every moment. Setting a damaged one aside does.
        if not self._load():
            with locked(self.path):
                if not self._load():
                    self._put_aside()

    def standing(self, lesson: str, version: int, exercise: str) -> Standing:
        """How the student stands with an exercise."""
        return standing(self.events, lesson, version, exercise)

    def begin(self) -> None:
        """Settle the seed, in the file."""
        if not self.seed:
            self._add(None)

    def add(self, event: Event) -> None:
        """Keep an event; it is on the disk when this comes back.

        Raises:
            FileError: it cannot be written.
        """
        self._add(event)

    def _add(self, event: Event | None) -> None:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with locked(self.path):
                self._append(event)
        except OSError as error:
            raise FileError(f"{self.path.parent}: cannot be made: {error.strerror}; {ELSEWHERE}") from None
        except FileError as error:
            raise FileError(f"{error}; {ELSEWHERE}") from None

    def _append(self, event: Event | None) -> None:
        # Another window may have added to it.
        if not self._load():
            self._put_aside()
        # What is there already is not written anew: a long history costs no more than its bytes.
        known = self._raw.decode() if self._raw else _line(self._head())
        self._write(known + (_line(asdict(event)) if event else ""))
        if event:
            self.events.append(event)

    def _load(self) -> bool:
        """Take in the file, as much of it as is sound; whether all of it is."""
        try:
            raw = self.path.read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            self._raw, self.events = b"", []
            return True
        except OSError as error:
            raise FileError(f"{self.path}: cannot be read: {error.strerror}") from None
        if raw and raw == self._raw:
            return True
        head, events, sound = _parse(raw)
        if head.get("format", FORMAT) != FORMAT:
            raise FileError(f"{self.path}: was written by a newer KinLab (format {head['format']})")
        self.events = events
        self.seed = head.get("seed") or self.seed
        self._raw = raw if sound else b""
        return sound

    def _head(self) -> dict[str, Any]:
        self.seed = self.seed or self._new_seed()
        return {"format": FORMAT, "profile": self.profile, "seed": self.seed}

    def _new_seed(self) -> str:
        # Without a name of one's own the numbers must still differ from a neighbour's.
        return secrets.token_hex(8) if self.profile == PROFILE else self.profile.casefold()

    def _put_aside(self) -> None:
        """Keep a copy of a damaged file under another name, then go on with what could be read."""
        stamp = datetime.now(UTC).strftime("%Y%m%d-%H%M%S")
        names = (f"{self.path.name}.damaged-{stamp}{f'-{i}' if i else ''}" for i in count())
        goal = next(path for name in names if not (path := self.path.with_name(name)).exists())
        write_whole(goal, self.path.read_bytes(), lasting=True)
        self.set_aside = goal
        self._write("".join(map(_line, (self._head(), *map(asdict, self.events)))))

    def _write(self, text: str) -> None:
        write_whole(self.path, text, lasting=True)
        self._raw = text.encode()
        for draft in self.path.parent.glob(f".{self.path.name}.*"):
            # Left behind by a program that was killed; under the lock nobody else is writing.
            with suppress(OSError):
                draft.unlink()


def _line(data: Mapping[str, Any]) -> str:
    return json.dumps(data, ensure_ascii=False) + "\n"


class Unkept(Progress):
    """Progress in memory alone, as a check, a preview or a lecturer's recomputation needs it."""

    def __init__(self, seed: str, profile: str = "") -> None:
        self.profile = profile
        self.seed = seed
        self.events = []
        self.set_aside = None

    def refresh(self) -> None:
        """Nobody else adds to it."""

    def _add(self, event: Event | None) -> None:
        if event:
            self.events.append(event)


def _parse(raw: bytes) -> tuple[dict[str, Any], list[Event], bool]:
    """The head and the events of a file, and whether all of it is sound."""
    head: dict[str, Any] = {}
    events = []
    sound = raw.endswith(b"\n")
    for number, line in enumerate(raw.decode("utf-8", errors="replace").split("\n")):
        if not line.strip():
            continue
        try:
            data = json.loads(line)
            if number == 0 and isinstance(data, dict) and isinstance(data.get("seed"), str):
                data["seed"].encode()
                head = data
            else:
                events.append(Event.read(data))
        except (ValueError, RecursionError):
            sound = False
            # Another seed would make every answer that was given one to other numbers.
            if number == 0 and (seed := _SEED.search(line)):
                head = {"seed": seed[1]}
    if "\ufffd" in raw.decode("utf-8", errors="replace") and b"\xef\xbf\xbd" not in raw:
        sound = False
    return head, events, sound and bool(head)


def progress_folder() -> Path:
    """Where profiles are kept, among what is the user's own."""
    return own_folder() / "progress"


def profiles(folder: Path | None = None) -> list[str]:
    """The profiles that there are."""
    return sorted(path.name.removesuffix(ENDING) for path in (folder or progress_folder()).glob(f"*{ENDING}"))
