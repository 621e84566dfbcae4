"""From the TOML of a lesson's blocks to exercises, figures, parameters and calls, each field checked."""

from collections.abc import Callable, Iterable, Mapping
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from kinlab.lessons.format import (
    CALL,
    CODES,
    EXERCISE,
    FIGURE,
    FRONT,
    KINDS,
    OPTION,
    SLIP,
    VALUE,
    Field,
    FormatError,
    check,
    holds,
)
from kinlab.lessons.lesson import Call, Drawn, Exercise, Figure, Parameter, Place, Wording
from kinlab.names import suggestion

if TYPE_CHECKING:
    from kinlab.lessons.reading import Block, Page

At = Callable[[str | None], Place]
MOST_CHOICES = 1000


def build_figure(texts: Mapping[str, "Block"]) -> Figure:
    """A figure from its block in each language.

    Raises:
        LessonError: a field is unknown, missing or wrong.
    """
    block = texts["en"]
    checked(block.data, FIGURE, block.at)
    alt = {code: each.data["alt"] for code, each in texts.items() if "alt" in each.data}
    draw = call(block.data["draw"], block.data.get("with", {}), block.at("draw"))
    return Figure(block.data["id"], draw, alt, block.place)


def build_exercise(texts: Mapping[str, "Block"]) -> Exercise:
    """An exercise from its block in each language.

    Raises:
        LessonError: a field is unknown, missing or wrong.
    """
    block = texts["en"]
    data = block.data
    fields = exercise_fields(data, block.at)
    checked(data, fields, block.at)
    _check_kind(data, block.at)
    for slip in data.get("slips", ()):
        checked(slip, SLIP, block.at)
    slips = tuple(
        call(slip["compute"], slip.get("with", {}), block.at("slips")) for slip in data.get("slips", ())
    )
    english = _wording(data, None)
    wording = {code: english if code == "en" else _wording(b.data, english) for code, b in texts.items()}
    return Exercise(
        data["id"], data["kind"], {name: data[name] for name in KINDS[data["kind"]] if name in data},
        drawn(data, block.at), call(data["answer"], data.get("with", {}), block.at("answer")),
        slips, wording, block.place,
    )  # fmt: skip


def exercise_fields(data: Mapping[str, Any], at: At) -> Mapping[str, Field]:
    """The fields that an exercise of this kind has."""
    if "kind" not in data:
        raise at(None).error(f"the field 'kind' is missing: one of {', '.join(KINDS)}")
    kind = str(data["kind"])
    if kind not in KINDS:
        raise at("kind").error(f"there is no kind of exercise '{kind}'{suggestion(kind, KINDS)}")
    return {**EXERCISE, **KINDS[kind]}


def _check_kind(data: Mapping[str, Any], at: At) -> None:
    """What the fields of one kind demand of each other."""
    if data["kind"] == "choice":
        for key, option in data["options"].items():
            if not isinstance(option, dict):
                raise at(key).error(f"option '{key}' is a table with text and why")
            checked(option, OPTION, at)
        if len(data["options"]) < 2:
            raise at("options").error("a choice has at least two options")
    if data["kind"] == "mistake" and len(data["why"]) != len(data["lines"]):
        raise at("why").error(f"'why' says something of each of the {len(data['lines'])} lines")
    if data["kind"] == "number" and not {"tolerance", "relative"} & data.keys():
        raise at(None).error("a number has a 'tolerance' in its unit, or a 'relative' one (0.01 for 1 %)")
    if not data["hints"]:
        raise at("hints").error("an exercise has at least one hint")
    codes = CODES[data["kind"]]
    for code in data.get("feedback", {}):
        if code not in codes:
            raise at(code).error(f"'{data['kind']}' has no verdict '{code}'{suggestion(code, codes)}")


def _wording(data: Mapping[str, Any], english: Wording | None) -> Wording:
    """The texts of a block; what is missing is taken from English."""
    base = english or Wording("")
    options = data.get("options", {})
    said = data.get("why", [])
    why = {key: o["why"] for key, o in options.items() if "why" in o}
    why.update({str(i): text for i, text in enumerate(said, 1)})
    slips = tuple(slip.get("say", "") for slip in data.get("slips", ()))
    return Wording(
        data.get("ask", base.ask),
        tuple(data.get("hints", base.hints)),
        data.get("solution", base.solution),
        {**base.feedback, **data.get("feedback", {})},
        slips if len(slips) >= len(base.slips) else (*slips, *base.slips[len(slips) :]),
        {**base.options, **{key: o["text"] for key, o in options.items() if "text" in o}},
        {**base.why, **why},
        {**base.items, **data.get("items", {})},
    )


def check_translation(page: "Page", english: "Page") -> None:
    """Refuse a translation that says more, or something else, than texts.

    Raises:
        LessonError: with the line.
    """
    checked(page.front, FRONT, page.at, translation=True)
    originals = english.blocks
    for name, block in page.blocks.items():
        if name not in originals:
            raise block.at("id").error(f"en.md has no block '{name}'{suggestion(name, originals)}")
        original = originals[name]
        if original.kind != block.kind:
            raise block.place.error(f"'{name}' is {_an(original.kind)} in en.md")
        if block.kind == "figure":
            checked(block.data, FIGURE, block.at, translation=True)
            continue
        fields = exercise_fields(original.data, original.at)
        checked(block.data, fields, block.at, translation=True)
        for table, inner in (("options", OPTION), ("slips", SLIP)):
            entries = block.data.get(table, {})
            for entry in entries.values() if isinstance(entries, dict) else entries:
                if isinstance(entry, dict):
                    checked(entry, inner, block.at, translation=True)
                else:
                    raise block.at(table).error(f"'{table}' holds tables")
        for table in ("options", "items"):
            for key in block.data.get(table, {}):
                if key not in original.data.get(table, {}):
                    near = suggestion(key, original.data.get(table, {}))
                    raise block.at(key).error(f"'{name}' has no '{key}' in en.md{near}")


def _an(kind: str) -> str:
    return f"an {kind}" if kind[0] in "aeiou" else f"a {kind}"


def checked(
    data: Mapping[str, Any], fields: Mapping[str, Field], at: At, *, translation: bool = False
) -> None:
    """`check`, its complaint at the line that it is about."""
    try:
        check(data, fields, translation=translation)
        for name, field in fields.items():
            if field.holds == "table" and name in ("feedback", "items"):
                wrong = next((k for k, v in data.get(name, {}).items() if not isinstance(v, str)), None)
                if wrong is not None:
                    raise FormatError(f"'{wrong}' is a text in quotes", wrong)
    except FormatError as error:
        raise at(error.key).error(str(error)) from None


def call(named: str | Mapping[str, Any], given: Mapping[str, Any], place: Place) -> Call:
    """A call as a lesson writes it: "leg.foot", or {compute = "leg.foot", with = {...}}."""
    if isinstance(named, str):
        return Call(named, dict(given), place)
    checked(named, CALL, lambda key: place)
    return call(named["compute"], {**given, **named.get("with", {})}, place)


def drawn(data: Mapping[str, Any], at: At) -> Drawn:
    """The parameters, the requirement and the values of a lesson or an exercise."""
    values = {}
    for name, value in data.get("values", {}).items():
        if not isinstance(value, dict):
            raise at(name).error(f"value '{name}' is a table with compute")
        checked(value, VALUE, at)
        values[name] = call(value["compute"], value.get("with", {}), at(name))
    require = data.get("require")
    parameters = tuple(_parameter(name, spec, at(name)) for name, spec in data.get("params", {}).items())
    return Drawn(parameters, None if require is None else call(require, {}, at("require")), values)


def _parameter(name: str, spec: Any, place: Place) -> Parameter:
    if not name.isidentifier():
        raise place.error(f"'{name}' is no name for a parameter: letters, digits and _")
    choices: Iterable[Any]
    if isinstance(spec, dict) and spec.keys() == {"pick"} and isinstance(spec["pick"], list) and spec["pick"]:
        choices = spec["pick"]
        if not all(isinstance(choice, str | bool) or holds(choice, "number") for choice in choices):
            raise place.error(f"parameter '{name}' picks among numbers and texts")
    elif isinstance(spec, dict) and spec.keys() == {"from", "to", "step"}:
        choices = _grid(name, spec, place)
    else:
        raise place.error(
            f"parameter '{name}' is {{ from = 10, to = 40, step = 5 }} or {{ pick = [10, 20] }}, not {spec!r:.60}"
        )
    return Parameter(name, tuple(choices))


def _grid(name: str, spec: Mapping[str, Any], place: Place) -> list[int | float]:
    """The numbers of a grid, exact in decimal, so that every language draws the same ones."""
    if not all(holds(v, "number") for v in spec.values()):
        raise place.error(f"parameter '{name}' goes from a number to a number in steps of a number")
    first, last, step = (Decimal(str(spec[key])) for key in ("from", "to", "step"))
    if not (step > 0 and last >= first):
        raise place.error(f"parameter '{name}' goes up, in steps of more than 0")
    count = int((last - first) / step) + 1
    if count > MOST_CHOICES:
        raise place.error(f"parameter '{name}' has more than {MOST_CHOICES} values")
    grid = [first + i * step for i in range(count)]
    whole = all(isinstance(v, int) for v in spec.values())
    return [int(v) if whole else float(v) for v in grid]
