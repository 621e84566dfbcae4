"""A lesson at the plain terminal: text comes, a question waits, the answer is judged."""

import sys
from collections.abc import Callable
from contextlib import suppress
from enum import Enum, auto
from io import TextIOWrapper

import typer

from kinlab.cli.learn_prose import lines, width
from kinlab.cli.printing import print_lines
from kinlab.errors import KinlabError
from kinlab.lessons.course import Course
from kinlab.lessons.progress import TRIES_BEFORE_SOLUTION
from kinlab.lessons.prose import wrapped
from kinlab.lessons.replies import LONGEST_SCRIPT, UnreadableError, clean, quote
from kinlab.lessons.sitting import WIDTH, Sitting, Text
from kinlab.lessons.task import Task, did_you_mean

# What a student may type in the place of an answer, in both languages.
WORDS = {
    "hint": "hint", "hints": "hint", "petunjuk": "hint", "?": "hint",
    "solution": "solution", "solusi": "solution",
    "skip": "skip", "next": "skip", "lewati": "skip", "lanjut": "skip",
    "question": "question", "soal": "question",
    "done": "done", "selesai": "done",
    "again": "again", "ulangi": "again",
    "quit": "quit", "exit": "quit", "keluar": "quit",
    "help": "help", "bantuan": "help",
}  # fmt: skip
GLOSSARY = ("what ", "apa ")


class After(Enum):
    """What follows an exercise."""

    GO_ON = auto()
    QUIT = auto()


class Session:
    """One student, one lesson, one terminal."""

    def __init__(self, sitting: Sitting, course: Course, *, figures: bool, ascii_only: bool) -> None:
        """Set up.

        Args:
            sitting: of the student.
            course: for the glossary and for what comes next.
            figures: draw them; without, they are described in words.
            ascii_only: without braille.
        """
        self.sitting = sitting
        self.course = course
        self.figures = figures
        self.ascii_only = ascii_only

    def run(self) -> None:
        """The whole lesson, from its beginning; exercises that are done are passed by."""
        sitting = self.sitting
        if isinstance(sys.stdin, TextIOWrapper):
            sys.stdin.reconfigure(errors="replace")
        with suppress(ImportError):
            # Lines can be edited and called back.
            import readline  # noqa: F401
        self._welcome()
        number = 0
        fell_back = sitting.fallback
        for part in sitting.parts():
            typer.echo()
            if isinstance(part, Text | Task):
                if part.fallback and not fell_back:
                    self._say("fallback")
                fell_back = part.fallback
            if isinstance(part, Text):
                print_lines(lines(part.markdown))
            elif isinstance(part, Task):
                number += 1
                try:
                    after = self._exercise(part, number)
                except KeyboardInterrupt:
                    typer.echo()
                    self._say("kept", lesson=sitting.lesson.id)
                    raise
                if after is After.QUIT:
                    typer.echo()
                    self._say("kept", lesson=sitting.lesson.id)
                    return
            else:
                picture = sitting.picture(part, min(width() - 4, WIDTH), ascii_only=self.ascii_only)
                if self.figures:
                    print_lines(
                        [
                            [("", "    "), *((_COLOURS.get(role, ""), text) for text, role in row)]
                            for row in picture.rows
                        ]
                    )
                else:
                    print_lines(wrapped(picture.alt, width(), head="  "))
        self._farewell()

    def _welcome(self) -> None:
        lesson, sitting = self.sitting.lesson, self.sitting
        print_lines([[("verb", lesson.title(sitting.language))]])
        if sitting.fallback:
            self._say("fallback-lesson")
        self._say(
            "head",
            minutes=lesson.minutes,
            count=len(sitting.tasks),
            solved=len(sitting.tasks) - len(sitting.open),
        )
        if lesson.prerequisites:
            self._say("after", lessons=", ".join(lesson.prerequisites))
        self._say("goals")
        for goal in lesson.goals.get(sitting.language, lesson.goals["en"]):
            print_lines(wrapped(goal, width(), head="- "))
        self._say("how", tries=TRIES_BEFORE_SOLUTION)

    def _exercise(self, task: Task, number: int) -> After:
        sitting, name = self.sitting, task.exercise.id
        print_lines([[("header", sitting.say("talk.exercise", number=number, count=len(sitting.tasks)))]])
        print_lines(lines(sitting.question(name)))
        now = sitting.standing(name)
        if now.shown:
            self._markdown(sitting.say("talk.shown", text=task.solution))
            return After.GO_ON
        if now.solved:
            self._say("solved", style="good", reply=quote(sitting.answered(name)))
            return After.GO_ON
        answer = self._talk if task.exercise.kind == "state" else self._answer
        return self._ask(task, answer(task))

    def _ask(self, task: Task, answered: Callable[[str], bool]) -> After:
        """Read lines until one of them is the answer, or the student goes on without."""
        prompt = "talk.prompt-state" if task.exercise.kind == "state" else "talk.prompt"
        while True:
            try:
                typed = input(self.sitting.say(prompt))
            except (EOFError, RuntimeError):
                # A RuntimeError where there is no standard input at all.
                typer.echo()
                return After.QUIT
            if not sys.stdin.isatty():
                typer.echo()
            word = WORDS.get(" ".join(typed.casefold().split()), "")
            if word == "quit":
                return After.QUIT
            if word == "skip":
                self._say("skipped")
                return After.GO_ON
            if word == "solution":
                if self._solution(task):
                    return After.GO_ON
            elif word and self._service(word, task):
                continue
            elif typed.casefold().startswith(GLOSSARY):
                self._explain(typed.split(" ", 1)[1].strip())
            elif answered(typed):
                return After.GO_ON

    def _service(self, word: str, task: Task) -> bool:
        """What a word asks for; False where it is for the chain, and elsewhere an answer like any other."""
        if word == "hint":
            self._hint(task)
        elif word == "question":
            print_lines(lines(self.sitting.question(task.exercise.id)))
        elif word == "help":
            state = task.exercise.kind == "state"
            self._say("how-state" if state else "how", tries=TRIES_BEFORE_SOLUTION)
            return not state
        else:
            return False
        return True

    def _answer(self, task: Task) -> Callable[[str], bool]:
        """One line is one answer."""
        return lambda typed: self._judged(task, typed)

    def _judged(self, task: Task, reply: str) -> bool:
        """Whether a reply is right; what there is to say is said."""
        verdict = self.sitting.check(task.exercise.id, reply)
        if verdict.ok:
            self._markdown(verdict.message, "good")
        elif not verdict.counts:
            self._markdown(verdict.message, "odd")
        else:
            self._markdown(self.sitting.say("talk.not-solved", message=verdict.message), "bad")
            self._offer(task)
        return verdict.ok

    def _talk(self, task: Task) -> Callable[[str], bool]:
        """Lines go to an emulated chain; the state is looked at after each."""
        self._say("how-state")
        bench = self.sitting.workbench(task.exercise.id)

        def answered(typed: str) -> bool:
            nonlocal bench
            word = WORDS.get(typed.strip().casefold())
            if word == "again":
                bench = self.sitting.workbench(task.exercise.id)
                self._say("again")
                return False
            if not typed.strip():
                return False
            if word != "done":
                try:
                    print_lines(bench.execute(clean(typed, LONGEST_SCRIPT)).lines)
                except UnreadableError as error:
                    self._markdown(task.say(f"unreadable.{error.code}", **error.values), "odd")
                except KinlabError as error:
                    self._complain(str(error))
                if not self.sitting.reached(task.exercise.id, bench.lines):
                    return False
            return self._judged(task, "\n".join(bench.lines))

        return answered

    def _complain(self, text: str) -> None:
        """What the bus or the sandbox says to a line; a caret below it stays where it points."""
        if "\n" in text:
            print_lines([[("odd", line)] for line in text.split("\n")])
        else:
            self._markdown(text, "odd")

    def _offer(self, task: Task) -> None:
        now = self.sitting.standing(task.exercise.id)
        if now.may_see_solution:
            self._say("offer-solution")
        elif now.hints < len(task.hints):
            self._say("offer-hint")

    def _hint(self, task: Task) -> None:
        hint = self.sitting.hint(task.exercise.id)
        if hint is None:
            self._say("no-more-hints")
        for each in [hint] if hint else self.sitting.hints(task.exercise.id):
            self._markdown(
                self.sitting.say("talk.hint", number=each.number, count=each.count, text=each.text)
            )

    def _solution(self, task: Task) -> bool:
        text = self.sitting.solution(task.exercise.id)
        if text is None:
            made = self.sitting.standing(task.exercise.id).tries
            self._say("no-solution", tries=TRIES_BEFORE_SOLUTION, made=made)
            return False
        self._markdown(self.sitting.say("talk.solution", text=text))
        return True

    def _explain(self, name: str) -> None:
        term = self.course.term(name)
        if term is None:
            self._say(
                "no-term",
                text=quote(name),
                near=did_you_mean(self.sitting.language, name, self.course.glossary),
            )
            return
        self._markdown(f"**{term.name}**: {term.meaning(self.sitting.language)}")

    def _farewell(self) -> None:
        sitting, lesson = self.sitting, self.sitting.lesson
        each = [sitting.standing(name) for name in sitting.tasks]
        typer.echo()
        self._say(
            "finished",
            style="good" if not sitting.open else "",
            solved=sum(now.status == "solved" for now in each),
            count=len(each),
            shown=sum(now.status == "shown" for now in each),
        )
        if sitting.open:
            self._say("left", names=", ".join(sitting.open))
            self._say("kept", lesson=lesson.id)
            return
        following = self.course.next_for(sitting.progress, after=lesson.id)
        if following:
            self._say("next", lesson=following.id, title=following.title(sitting.language))
        else:
            self._say("course-finished")

    def _say(self, key: str, *, style: str = "", **values: object) -> None:
        self._markdown(self.sitting.say(f"talk.{key}", **values), style)

    def _markdown(self, text: str, style: str = "") -> None:
        """A message, in one colour where it has one."""
        print_lines([[(style or look, part) for look, part in line] for line in lines(text)])


# Of a figure's parts, as the tables of `kinlab ik` colour them.
_COLOURS = {
    "link0": "length",
    "link1": "address",
    "link2": "data",
    "tip": "verb",
    "joint": "verb",
    "target": "instruction",
}
