"""Which language people are spoken to in, and how a room keeps its sentences."""

import pytest

from kinlab.errors import UsageError
from kinlab.language import LANGUAGES, Words, language


@pytest.mark.parametrize(
    ("environment", "spoken"),
    [
        ({}, "en"),
        ({"LANG": "C.UTF-8"}, "en"),
        ({"LANG": "id_ID.UTF-8"}, "id"),
        ({"LANG": "id"}, "id"),
        ({"LANG": "is_IS.UTF-8"}, "en"),
        ({"LANG": "en_US.UTF-8", "LC_ALL": "id_ID.UTF-8"}, "id"),
        ({"LANG": "id_ID.UTF-8", "LC_MESSAGES": "en_GB.UTF-8"}, "en"),
        ({"LANG": "en_US.UTF-8", "KINLAB_LANG": "id"}, "id"),
        ({"LANG": "in_ID"}, "id"),
        ({"LANG": "Indonesian_Indonesia.1252"}, "id"),
        ({"LANG": "en_US.UTF-8", "LANGUAGE": "id:en"}, "id"),
        ({"LANG": "id_ID.UTF-8", "LANGUAGE": "jv:en_GB"}, "en"),
        ({"LANG": "id_ID.UTF-8", "LANGUAGE": ""}, "id"),
        ({"LANG": "id_ID.UTF-8", "LC_ALL": "C.UTF-8", "LANGUAGE": "id"}, "en"),
        ({"LANGUAGE": "id"}, "en"),
    ],
)
def test_the_environment_names_the_language(environment: dict[str, str], spoken: str) -> None:
    assert language(environment=environment) == spoken


def test_what_is_asked_for_comes_before_the_environment() -> None:
    assert language("en", {"LANG": "id_ID.UTF-8"}) == "en"


@pytest.mark.parametrize("environment", [{}, {"KINLAB_LANG": "fr"}])
def test_an_unknown_language_is_refused_with_those_that_there_are(environment: dict[str, str]) -> None:
    with pytest.raises(UsageError, match="en, id"):
        language(None if environment else "fr", environment)


def test_a_sentence_is_said_in_each_language_with_its_values() -> None:
    words = Words({"landed": {"en": "lands {mm} mm off", "id": "meleset {mm} mm"}})
    assert [words.say(spoken, "landed", mm=3.1) for spoken in LANGUAGES] == [
        "lands 3.1 mm off",
        "meleset 3.1 mm",
    ]
