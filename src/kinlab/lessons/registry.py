"""What lessons may ask of the core, by name: `leg.foot` is the function `foot` in `answers/leg.py`.

A lesson holds no code. It names public functions of the modules in `answers/` (right answers, values,
requirements) and `figures/` (pictures), and they are called with its parameters by their names.
"""

import inspect
from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from kinlab.errors import KinlabError
from kinlab.lessons.filling import PLACEHOLDER, UnknownNameError, fill
from kinlab.lessons.lesson import Call, LessonError
from kinlab.names import suggestion


@cache
def topics(room: str) -> tuple[str, ...]:
    """The modules of a room, "answers" or "figures"."""
    package = import_module(f"kinlab.lessons.{room}")
    return tuple(sorted(module.name for module in iter_modules(package.__path__)))


@cache
def functions(room: str, topic: str) -> Mapping[str, Callable[..., Any]]:
    """The public functions of a module, by name."""
    module = import_module(f"kinlab.lessons.{room}.{topic}")
    return {
        name: function
        for name, function in vars(module).items()
        if inspect.isfunction(function)
        and function.__module__ == module.__name__
        and not name.startswith("_")
    }


def find(call: Call, room: str) -> Callable[..., Any]:
    """The function that a call names.

    Raises:
        LessonError: there is none; the nearest names are given.
    """
    topic, _, name = call.name.partition(".")
    if topic not in topics(room):
        raise call.place.error(
            f"{room} have no topic '{topic}' (of '{call.name}'){suggestion(topic, topics(room))}"
        )
    known = functions(room, topic)
    if name not in known:
        raise call.place.error(
            f"the topic {topic} of {room} has no '{name}' (of '{call.name}'){suggestion(name, known)}"
        )
    return known[name]


@cache
def takes(function: Callable[..., Any]) -> Mapping[str, inspect.Parameter]:
    """The parameters of a function, by name."""
    return inspect.signature(function).parameters


def arguments(call: Call, room: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """What the function is called with: what the lesson gives, else the value of the parameter's own name.

    Raises:
        LessonError: something is missing, or given and not taken.
    """
    taken = takes(find(call, room))
    for name in call.given:
        if name not in taken:
            raise call.place.error(f"{call.name} takes no '{name}'{suggestion(name, taken)}")
    found = {}
    for name, parameter in taken.items():
        if name in call.given:
            found[name] = _given(call, call.given[name], values)
        elif name in values:
            found[name] = values[name]
        elif parameter.default is inspect.Parameter.empty:
            raise call.place.error(f"{call.name} needs '{name}', which no parameter or value is named")
    return found


def _given(call: Call, value: Any, values: Mapping[str, Any]) -> Any:
    """A constant, the value that "{name}" stands for, or a list of such."""
    if isinstance(value, list):
        return [_given(call, each, values) for each in value]
    if not isinstance(value, str):
        return value
    whole = PLACEHOLDER.fullmatch(value)
    if whole and not whole[2] and whole[1] in values:
        return values[whole[1]]
    try:
        return fill(value, values)
    except UnknownNameError as error:
        raise call.place.error(str(error)) from None


def evaluate(call: Call, room: str, values: Mapping[str, Any]) -> Any:
    """What the core computes for a call.

    Raises:
        LessonError: it cannot, with the reason.
    """
    given = arguments(call, room, values)
    function = find(call, room)
    key = (function, repr(sorted(given.items()))) if _plain(list(given.values())) else None
    if key in _COMPUTED:
        return _COMPUTED[key]
    try:
        found = function(**given)
    except LessonError:
        raise
    except KinlabError as error:
        raise call.place.error(f"{call.name}: {error}") from None
    except Exception as error:
        # What a lesson gives may be of the wrong kind in every way; the lesson is at fault, not the program.
        shown = ", ".join(f"{name}={value!r:.40}" for name, value in given.items())
        raise call.place.error(f"{call.name}({shown}) failed: {type(error).__name__}: {error}") from None
    if key:
        if len(_COMPUTED) >= MOST_KEPT:
            _COMPUTED.clear()
        _COMPUTED[key] = found
    return found


# What was computed last: the same for the same arguments, and asked for again by every text and every try.
_COMPUTED: dict[Any, Any] = {}
MOST_KEPT = 20_000


def _plain(value: Any) -> bool:
    """Whether a value's `repr` says all of it."""
    if isinstance(value, list | tuple):
        return all(_plain(each) for each in value)
    if isinstance(value, dict):
        return all(isinstance(key, str) and _plain(each) for key, each in value.items())
    return type(value) in (int, float, str, bool)
