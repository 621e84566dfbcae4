"""What the station says of lessons and exercises, as blocks of text."""

from collections.abc import Callable

from kinlab.lessons import Course, Figure, Lesson, Progress, Sitting, Verdict
from kinlab.lessons.kinds import offers
from kinlab.lessons.sitting import Step
from kinlab.tui.stations.lessons.browser import Row
from kinlab.tui.stations.lessons.flow import Block
from kinlab.tui.stations.lessons.seat import Seat, Table

Say = Callable[..., str]
TITLE = "bold $sky"
QUIET = "$quiet"
BREAK = "  \n"  # of a line, in Markdown


def rows(course: Course, progress: Progress, language: str, say: Say) -> list[Row]:
    """The list of lessons; those that cannot be read come last, with the reason."""
    found = []
    for number, lesson in enumerate(course.lessons.values(), 1):
        each = [progress.standing(lesson.id, lesson.version, e.id) for e in lesson.exercises]
        done = sum(now.done for now in each)
        begun = any(now.done or now.tries or now.hints for now in each)
        standing = "solved" if done == len(each) else "begun" if begun else "open"
        if standing == "solved" and any(now.shown for now in each):
            standing = "shown"
        facts = f"{say('minutes', minutes=lesson.minutes)}  {done}/{len(each)}"
        about = _about(course, lesson, progress, language, say)
        found.append(Row(lesson.id, standing, str(number), lesson.title(language), facts, about))
    for problem in course.problems:
        text = str(problem)
        about = (Block(say("broken"), style="$vermillion"), Block(f"    {text}"))
        found.append(Row("", "broken", "", text.partition("/")[0], say("unreadable"), about))
    return found


def tally(course: Course, progress: Progress, say: Say) -> str:
    """How far the student is, in a few words."""
    each = [
        progress.standing(lesson.id, lesson.version, exercise.id).status
        for lesson in course.lessons.values()
        for exercise in lesson.exercises
    ]
    return say("tally", profile=progress.profile, solved=each.count("solved"), count=len(each))


def _about(course: Course, lesson: Lesson, progress: Progress, language: str, say: Say) -> tuple[Block, ...]:
    goals = "\n".join(f"- {goal}" for goal in lesson.goals.get(language, lesson.goals["en"]))
    lines = [Block(f"{say('goals')}\n{goals}")]
    facts = []
    if lesson.prerequisites:
        titles = (
            f"'{course.lessons[p].title(language)}'" if p in course.lessons else p
            for p in lesson.prerequisites
        )
        facts.append(say("after", lessons=", ".join(titles)))
    if lesson.robot:
        facts.append(say("robot", robot=lesson.robot))
    if language not in lesson.languages:
        facts.append(say("english"))
    each = [progress.standing(lesson.id, lesson.version, e.id).status for e in lesson.exercises]
    if "shown" in each:
        facts.append(say("shown_count", count=each.count("shown")))
    return (*lines, *([Block(" ".join(facts), style=QUIET)] if facts else []))


def page(course: Course, seat: Seat, say: Say) -> list[Block]:
    """What there is to read for the exercise of now; at the end, how the lesson went."""
    found = []
    lesson, sitting = seat.sitting.lesson, seat.sitting
    if seat.at == 0:
        if sitting.fallback:
            found.append(Block(say("english"), style="$orange"))
        done = len(sitting.tasks) - len(sitting.open)
        head = say("head", minutes=lesson.minutes, count=len(sitting.tasks), solved=done)
        goals = lesson.goals.get(sitting.language, lesson.goals["en"])
        found.append(
            Block("\n".join((f"{head} {say('goals')}", *(f"- {goal}" for goal in goals))), style=QUIET)
        )
    step = seat.steps[seat.at]
    # What belongs to two exercises stands before the first.
    for part in next((s.parts for s in reversed(seat.steps[: seat.at + 1]) if s.parts), ()):
        if isinstance(part, Figure):
            found.append(Block(figure=part))
        else:
            mark = part.fallback and not sitting.fallback
            found.append(Block(part.markdown, head="(en) " if mark else ""))
    if step.task is None:
        found += _farewell(course, sitting, say)
    return found


def _farewell(course: Course, sitting: Sitting, say: Say) -> list[Block]:
    each = [sitting.standing(name).status for name in sitting.tasks]
    key = "finished" if "open" not in each else "so_far"
    said = say(key, solved=each.count("solved"), count=len(each), shown=each.count("shown"))
    found = [Block(said, style="bold $sky" if key == "finished" else "bold $orange")]
    following = course.next_for(sitting.progress)
    if "open" in each:
        found.append(Block(say("left")))
    elif following is None:
        found.append(Block(say("course_finished"), style="bold $sky"))
    else:
        found.append(Block(say("next", title=following.title(sitting.language))))
    return found


def question(seat: Seat, say: Say) -> list[Block]:
    """The exercise of now."""
    task, step = seat.task, seat.steps[seat.at]
    if task is None:
        return []
    now = seat.sitting.standing(seat.name)
    head = seat.sitting.say("talk.exercise", number=seat.at + 1, count=len(seat.sitting.tasks))
    state = {
        "solved": say("solved"),
        "shown": say("shown"),
        "open": say("tries", count=now.tries) if now.tries else "",
    }
    found = [Block(f"{head}  {state[now.status]}".rstrip(), style=TITLE)]
    return [*found, *_asked(seat, step, say)]


def _asked(seat: Seat, step: Step, say: Say) -> list[Block]:
    assert step.task is not None
    head = "(en) " if step.task.fallback and not seat.sitting.fallback else ""
    if not offers(step.task):
        return [Block(seat.sitting.question(seat.name), head=head)]
    rotation = step.task.field.get("rotation")
    key = "rotation" if rotation else step.task.exercise.kind
    return [Block(step.task.ask, head=head), Block(say(f"how.{key}"), style=QUIET)]


def aid(seat: Seat, table: Table, say: Say) -> list[Block]:
    """The hint that is looked at, and the solution."""
    found = []
    hints = seat.sitting.hints(seat.name)
    if 0 <= table.hint < len(hints):
        hint = hints[table.hint]
        more = f"  {say('earlier')}" if hint.number > 1 else ""
        head = say("hint", number=hint.number, count=hint.count)
        found.append(Block(f"**{head}**{more}{BREAK}{hint.text}"))
    if table.solution:
        found.append(Block(f"**{say('the_solution')}**{BREAK}{table.solution}"))
    return found


def verdict(said: Verdict, sitting: Sitting, ascii_only: bool) -> Block:
    """What is said to an answer, with a sign."""
    if said.ok:
        return Block(said.message, style="bold $sky", head="+ " if ascii_only else "● ")
    if not said.counts:
        return Block(said.message, style="$orange", head="! " if ascii_only else "▲ ")
    message = sitting.say("talk.not-solved", message=said.message)
    return Block(message, style="bold $vermillion", head="x " if ascii_only else "■ ")
