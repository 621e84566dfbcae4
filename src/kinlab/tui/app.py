"""The application: stations as modes, themes, languages, settings; nothing of the laboratory itself."""

import asyncio
import gc
import os
import re
import signal
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any, ClassVar

from rich.text import Text
from textual.app import App, SystemCommand
from textual.binding import Binding, BindingType
from textual.screen import Screen

from kinlab.canvas import without_braille
from kinlab.endings import endings
from kinlab.errors import KinlabError, UsageError
from kinlab.files import own_folder
from kinlab.language import LANGUAGES, language, words_of
from kinlab.tui import themes
from kinlab.tui.actions import SHELL, Action, bindings
from kinlab.tui.settings import Settings
from kinlab.tui.station import Station
from kinlab.tui.stations import STATIONS

if TYPE_CHECKING:
    from textual.command import Provider

OPEN = tuple(
    Action(f"open_{name}", f"f{i + 1},{i}", f"app.open_station('{name}')", shown=False)
    for i, name in enumerate(STATIONS, 1)
)


def _station(name: str) -> type[Station]:
    module, _, made = STATIONS[name].partition(":")
    station: type[Station] = getattr(import_module(module), made)
    return station


def _opened(name: str) -> Screen[Any]:
    return _station(name)()


def _prepare(name: str) -> None:
    _station(name).prepare()


def _commands() -> "type[Provider]":
    from kinlab.tui.palette import Actions

    return Actions


class KinlabApp(App[None]):
    """The laboratory.

    Attributes:
        tongue: the language's code.
        ascii_only: whether drawings must do without braille and other signs.
        settings: what is kept between runs.
        unkept: why it could not be kept; empty where it could.
    """

    MODES: ClassVar[dict[str, str | Callable[[], Screen[Any]]]] = {
        name: partial(_opened, name) for name in STATIONS
    }
    COMMANDS: ClassVar[set["type[Provider] | Callable[[], type[Provider]]"]] = {_commands}
    BINDINGS: ClassVar[list[BindingType]] = bindings((*SHELL, *OPEN))
    # Textual declares these in a way that reads as attributes of an instance.
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (80, "-normal"), (120, "-wide")]  # noqa: RUF012
    VERTICAL_BREAKPOINTS = [(0, "-low"), (30, "-tall")]  # noqa: RUF012
    ESCAPE_TO_MINIMIZE = False
    TITLE = "KinLab"
    CSS = """
    SearchIcon { display: none; }
    ToastRack { margin-bottom: 2; }
    Tooltip { background: $panel; color: $foreground; }
    """

    def __init__(self, station: str | None = None, *, folder: Path | None = None) -> None:
        """The application.

        Args:
            station: to open; default the one that was open last.
            folder: where settings are kept; default the user's state folder.
        """
        super().__init__()
        self.folder = folder or own_folder()
        self.unkept = ""
        self.settings, self.set_aside = Settings.load(self.folder / "tui.json")
        self.tongue = self._first_language()
        self.ascii_only = without_braille()
        self._station = next((name for name in (station, self.settings.station) if name in STATIONS), "robot")
        for theme in themes.THEMES:
            self.register_theme(theme)
        known = {theme.name for theme in themes.THEMES}
        # Set before anything is drawn, so that nothing is styled twice.
        self.set_reactive(
            App.theme, self.settings.theme if self.settings.theme in known else themes.DARK.name
        )
        self.stylesheet.set_variables(self.get_css_variables())

    def _first_language(self) -> str:
        if os.environ.get("KINLAB_LANG") or self.settings.language not in LANGUAGES:
            try:
                return language()
            except UsageError:
                return "en"
        return str(self.settings.language)

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """The colours that the stations' styles name, for themes that do not define them."""
        return themes.DEFAULTS

    def get_key_display(self, binding: Binding) -> str:
        """A key as it is printed on keyboards: F7, not f7."""
        name = super().get_key_display(binding)
        return name.upper() if re.fullmatch(r"f\d+", name) else name

    def get_system_commands(self, screen: Screen[Any]) -> Iterable[SystemCommand]:
        """None: the palette shows the actions of the registry, in the language of now."""
        return ()

    def on_mount(self) -> None:
        # A terminal that is closed, or a process that is ended, is left as by the key: what was chosen is kept.
        for ending in endings():
            with suppress(NotImplementedError):
                asyncio.get_running_loop().add_signal_handler(ending, self.exit)
        self._guard_resuming()
        self._show(self._station)
        if self.set_aside is not None:
            text = words_of("kinlab.tui").say(self.tongue, "shell.damaged", file=self.set_aside)
            self.notify(text, severity="warning", timeout=10, markup=False)

    def _guard_resuming(self) -> None:
        """Let SIGCONT bring back the screen once, whatever has stopped the program, or nothing has.

        A terminal that hangs up sends it too, and `kill -STOP` announces nothing. Textual then reads the keys
        in a second thread beside the first, which never ends; and what it resumes it does not draw.
        """
        driver = self._driver
        resume = signal.getsignal(signal.SIGCONT) if hasattr(signal, "SIGCONT") else None
        if driver is None or not callable(resume):
            return

        def go_on(number: int, frame: FrameType | None) -> None:
            if self.is_running:
                if not getattr(driver, "_must_signal_resume", True):
                    driver.suspend_application_mode()
                resume(number, frame)
                self.call_later(self.refresh, layout=True)

        signal.signal(signal.SIGCONT, go_on)

    # Stations.

    def _show(self, name: str) -> None:
        self.settings.station = name
        new = name not in self._screen_stacks
        # Searches for garbage take longer than a frame where they go through all that a station brings.
        if new:
            gc.disable()
        self.switch_mode(name)
        if new:
            self.call_after_refresh(self._settle)

    def _settle(self) -> None:
        """What a station has brought stays: nothing looks for garbage in it any more."""
        gc.freeze()
        gc.enable()

    async def open_station(self, name: str) -> None:
        """Go to a station; what is on the screen lives on while a new one is brought in."""
        self._wanted = name
        if name not in self._screen_stacks:
            await asyncio.to_thread(_prepare, name)
        if self._wanted == name:
            self._show(name)

    async def action_open_station(self, name: str) -> None:
        """Go to a station."""
        await self.open_station(name)

    async def action_next_station(self) -> None:
        """Go to the next station in the bar; after the last comes the first."""
        names = list(STATIONS)
        await self.open_station(names[(names.index(self.settings.station) + 1) % len(names)])

    @property
    def stations(self) -> list[Station]:
        """The stations that have been opened."""
        found = [screen for stack in self._screen_stacks.values() for screen in stack]
        return [screen for screen in found if isinstance(screen, Station)]

    # Comfort.

    def action_help(self) -> None:
        """Show the help of the station."""
        from kinlab.tui.help import Help

        if isinstance(self.screen, Station):
            self.push_screen(Help(self.screen))

    def action_theme(self) -> None:
        """Change between dark and light."""
        dark = self.theme == themes.DARK.name
        self.theme = self.settings.theme = themes.LIGHT.name if dark else themes.DARK.name

    def action_language(self) -> None:
        """Speak the next language."""
        codes = list(LANGUAGES)
        self.tongue = codes[(codes.index(self.tongue) + 1) % len(codes)]
        self.settings.language = self.tongue
        for station in self.stations:
            station.speak()

    def action_command_palette(self) -> None:
        """Open the palette, with its question in the language of now."""
        from textual.command import CommandPalette

        if not isinstance(self.screen, CommandPalette):
            question = words_of("kinlab.tui").say(self.tongue, "shell.search")
            self.push_screen(CommandPalette(placeholder=question, id="--command-palette"))

    def action_help_quit(self) -> None:
        """Ctrl-C where nothing is selected to be copied: leave, as everywhere in a terminal."""
        self.exit()

    # The end.

    def keep(self) -> None:
        """Write down what is kept until the next run."""
        for station in self.stations:
            if station.is_mounted:
                self.settings.stations[station.NAME] = station.state()
        self.unkept = self.settings.save(self.folder / "tui.json")

    def exit(self, *args: Any, **settings: Any) -> None:
        """Keep the settings, and leave."""
        self.keep()
        super().exit(*args, **settings)

    def _handle_exception(self, error: Exception) -> None:
        """An error; where somebody has left, what was under way has no screen to show itself on: that is none."""
        if self.is_running:
            super()._handle_exception(error)

    def _fatal_error(self) -> None:
        """KinLab itself has failed: no page of code, but where the report is and what is asked for.

        What a person's file or request caused (a robots file that became unreadable meanwhile) is told as
        everywhere on the command line.
        """
        from kinlab.tui.crash import write_report

        if isinstance(self._exception, KinlabError):
            self._return_code = self._exception.exit_code
            self._exit_renderables.append(Text(f"kinlab: {self._exception}"))
            self._close_messages_no_wait()
            return
        report = write_report(self._exception, self.folder) if self._exception else None
        say = words_of("kinlab.tui").say
        cause = f"{type(self._exception).__name__}: {self._exception}"
        lines = [say(self.tongue, "shell.crash", cause=cause)]
        if report is not None:
            lines.append(say(self.tongue, "shell.report", file=report))
        self._exit_renderables.append(Text("\n".join(lines)))
        self._close_messages_no_wait()


def run(station: str | None = None) -> int:
    """Open the laboratory in this terminal, until a person leaves it; its exit code."""
    os.environ.setdefault("TEXTUAL_ANIMATIONS", "none")
    try:
        _check_own_files()
    except KinlabError as error:
        sys.stderr.write(f"kinlab: {error}\n")
        return error.exit_code
    app = KinlabApp(station)
    app.animation_level = "none"
    app.run()
    if app.unkept:
        told = words_of("kinlab.tui").say(app.tongue, "shell.unkept", why=app.unkept)
        sys.stderr.write(f"kinlab: {told}\n")
    return app.return_code or 0


def _check_own_files() -> None:
    """Read what the environment names before anything opens.

    Raises:
        KinlabError: it cannot be read.
    """
    if os.environ.get("KINLAB_ROBOTS"):
        from kinlab.robots import robot_names

        robot_names()
    if folder := os.environ.get("KINLAB_LESSONS"):
        from kinlab.lessons.course import lesson_folders

        lesson_folders(Path(folder))
