"""The language that people are spoken to in: English, or Bahasa Indonesia."""

import os
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files

from kinlab.names import resolve

LANGUAGES = {"en": "English", "id": "Bahasa Indonesia"}
# Old systems write "in", Windows the name.
_OTHER_CODES = {"in": "id", "indonesian": "id", "indonesia": "id"}


def language(wanted: str | None = None, environment: Mapping[str, str] = os.environ) -> str:
    """The language's code: `wanted`, else what $KINLAB_LANG or the locale names, else English.

    Raises:
        UsageError: `wanted` or $KINLAB_LANG names a language that there is not.
    """
    wanted = wanted or environment.get("KINLAB_LANG")
    if wanted:
        return resolve(wanted, LANGUAGES, "language")
    locale = next(
        (environment[key] for key in ("LC_ALL", "LC_MESSAGES", "LANG") if environment.get(key)), "C"
    )
    # As gettext does it: a list in $LANGUAGE comes first, but where the locale is none that speaks.
    spoken = locale.partition(".")[0] not in ("C", "POSIX")
    for name in (*(environment.get("LANGUAGE", "").split(":") if spoken else ()), locale):
        code = re.split(r"[_.@-]", name.lower())[0]
        code = _OTHER_CODES.get(code, code)
        if code in LANGUAGES:
            return code
    return "en"


class Words:
    """The sentences of one room, each in every language, from the room's own `words.toml`.

    >>> Words({"greeting": {"en": "Hello, {name}", "id": "Halo, {name}"}}).say("id", "greeting", name="Ani")
    'Halo, Ani'
    """

    def __init__(self, entries: Mapping[str, Mapping[str, str]]) -> None:
        self.entries = entries

    def say(self, language: str, key: str, **values: object) -> str:
        """The sentence `key` in that language, its `{names}` filled in."""
        return self.entries[key][language].format(**values)


@cache
def words_of(package: str) -> Words:
    """The words in the file `words.toml` beside the package's code, read once; tables nest, names join by dots."""
    table = tomllib.loads(files(package).joinpath("words.toml").read_text(encoding="utf-8"))
    return Words(dict(_flat(table)))


def _flat(table: Mapping[str, object], path: str = "") -> list[tuple[str, Mapping[str, str]]]:
    found: list[tuple[str, Mapping[str, str]]] = []
    for key, value in table.items():
        assert isinstance(value, dict)
        name = f"{path}.{key}" if path else key
        if LANGUAGES.keys() <= value.keys():
            found.append((name, value))
        else:
            found.extend(_flat(value, name))
    return found
