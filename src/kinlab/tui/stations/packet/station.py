"""The Packet station: a packet byte by byte, what it does to a servo, and what goes wrong on the way."""

import asyncio
import time
from typing import Any

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.events import Click, Resize
from textual.widgets import Input, Select, Static

from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.outfit import known_chains
from kinlab.dynamixel.sandbox import Outcome, Session, execute, run_script
from kinlab.dynamixel.sandbox.commands import read_script
from kinlab.dynamixel.sandbox.inspection import elapse, holdings, revival, silence
from kinlab.dynamixel.sandbox.prompting import hint, preview
from kinlab.dynamixel.sandbox.session import DEFAULT_CHAIN, Line
from kinlab.dynamixel.sandbox.wire import exchange_lines
from kinlab.errors import KinlabError
from kinlab.tui.facts import fitting
from kinlab.tui.station import Station
from kinlab.tui.stations.packet.actions import ACTIONS
from kinlab.tui.stations.packet.condition import conditions
from kinlab.tui.stations.packet.prompt import Prompt
from kinlab.tui.stations.packet.registers import COLUMNS, Registers
from kinlab.tui.stations.packet.sheet import Sheet
from kinlab.tui.stations.packet.tabs import Tabs
from kinlab.tui.stations.packet.traffic import Traffic
from kinlab.tui.widgets import Choice, Said

VIEWS = ("packet", "registers", "traffic")
TICK = 0.2  # s between two looks at the registers
LONGEST_TICK = 1.0  # s of the chain's time for one of them, however long the program was stopped


class PacketStation(Station):
    """A line for the sandbox; above it the packet taken apart, the servo's registers, and what went over the wire.

    Attributes:
        session: the sandbox.
        servo: the id of the servo whose registers are shown.
        view: what is shown where there is no room for everything.
        held: whether the chain's time stands still.
    """

    NAME = "packet"
    ACTIONS = ACTIONS
    AUTO_FOCUS = "Prompt"
    CSS = """
    PacketStation {
        #choices { height: 1; padding: 0 1; }
        #choices Said { color: $quiet; margin: 0 1 0 0; display: none; }
        #choices Choice { margin: 0 1 0 0; width: 28; }
        #choices #servo { width: 19; }
        &.-narrow #chain { width: 22; }
        &.-wide #choices Said { display: block; }
        #condition { width: 1fr; height: 1; text-align: right; color: $quiet; }
        #panes { height: 1fr; }
        #packet, #registers, #traffic, #side { display: none; width: 1fr; height: 1fr; }
        .head { text-style: bold; padding: 0 1; height: 1; display: none; }
        &.view-packet #packet { display: block; }
        &.view-registers #side, &.view-registers #registers { display: block; }
        &.view-traffic #side, &.view-traffic #traffic { display: block; }
        &.-wide #packet, &.-wide #side, &.-wide #registers, &.-wide #traffic, &.-wide .head { display: block; }
        &.-wide #side { width: 45%; min-width: 66; border-left: solid $faint; }
        &.-wide #registers { height: 3fr; }
        &.-wide #traffic { height: 2fr; }
        &.-wide Tabs { display: none; }
        #typing { height: 1; padding: 0 1; background: $surface; }
        #sign { width: auto; color: $orange; text-style: bold; }
        #hint { height: 1; padding: 0 1; color: $quiet; background: $surface; }
        #hint, #condition { text-wrap: nowrap; text-overflow: ellipsis; }
        #silence { display: none; width: 100%; padding: 0 1; color: $vermillion; text-style: bold; }
        &.-silent #silence { display: block; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.session = Session()
        self.servo = self.session.ids()[0]
        self.view = VIEWS[0]
        self.held = False
        self._lines: list[Line] | None = None  # what the last line led to; None before the first one
        self._shown_sign = ""
        self._seen = time.monotonic()

    def compose_body(self) -> ComposeResult:
        with Horizontal(id="choices"):
            yield Said("chain")
            yield Choice([self.session.chain_text], self.session.chain_text, id="chain")
            yield Said("servo")
            yield Choice([self._named(self.servo)], self._named(self.servo), id="servo")
            yield Static(id="condition", markup=False)
        yield Tabs(VIEWS)
        with Horizontal(id="panes"):
            with Vertical(id="packet"):
                yield Said("tab.packet", classes="head")
                yield Sheet()
            with Vertical(id="side"):
                with Vertical(id="registers"):
                    yield Said("tab.registers", classes="head")
                    yield Registers()
                with Vertical(id="traffic"):
                    yield Said("tab.traffic", classes="head")
                    yield Traffic()
        yield Said("silent", id="silence", why="")
        with Horizontal(id="typing"):
            yield Static(id="sign", markup=False)
            yield Prompt(self.session)
        yield Static(id="hint", markup=False)

    def ready(self) -> None:
        self.relabel()
        self._show_view()
        self._meet_chain()
        self.set_interval(TICK, self._tick)

    # What is kept.

    def state(self) -> dict[str, Any]:
        return {
            "chain": self.session.chain_text,
            "servo": self.servo,
            "view": self.view,
            "history": self.query_one(Prompt).history,
        }

    def restore(self, state: dict[str, Any]) -> None:
        chain, servo, history = state.get("chain"), state.get("servo"), state.get("history")
        if isinstance(chain, str):
            try:
                self.session.use_chain(chain, self.session.port.baud)
            except KinlabError:
                self.session.use_chain(DEFAULT_CHAIN, self.session.port.baud)
        ids = self.session.ids()
        self.servo = servo if servo in ids else ids[0]
        self.view = state["view"] if state.get("view") in VIEWS else VIEWS[0]
        if isinstance(history, list):
            for line in history:
                self.query_one(Prompt).remember(str(line))

    # What is shown.

    def relabel(self) -> None:
        self.query_one(Registers).label({name: self.say(f"column.{name}") for name in COLUMNS})
        self.query_one(Prompt).placeholder = self.say("placeholder")
        self.query_one(Tabs).name_them({view: self.say(f"tab.{view}") for view in VIEWS}, self.view)
        self._show_packet()
        self._show_condition()
        self._show_hint()

    def _show_view(self) -> None:
        self.update_classes({f"view-{view}": view == self.view for view in VIEWS})
        self.query_one(Tabs).choose(self.view)

    def _meet_chain(self) -> None:
        """Show another chain, or its servos after their ids have changed."""
        chain, servos = self.session.chain_text, self.session.ids()
        names = list(dict.fromkeys([DEFAULT_CHAIN, *(name for name, _ in known_chains()), chain]))
        self.query_one("#chain", Choice).offer(names, chain)
        self.servo = self.servo if self.servo in servos else servos[0]
        self.query_one("#servo", Choice).offer([self._named(i) for i in servos], self._named(self.servo))
        self._show_registers()
        self._show_condition()

    def _named(self, servo: int) -> str:
        table = self.session.table(servo)
        return f"{servo} {table.model}" if table else str(servo)

    def _show_packet(self) -> None:
        """The packet that is being typed, else the one being assembled, else what the last line led to."""
        typed = preview(self.session, self.query_one(Prompt).value)
        if typed is not None:
            lines = typed.lines
        elif self._lines is not None:
            lines = self._lines
        else:
            lines = [
                [("verb" if i == 0 else "", line)] for i, line in enumerate(self.say("welcome").splitlines())
            ]
        self.query_one(Sheet).put(lines, to_end=typed is not None)
        if (sign := self._sign()) != self._shown_sign:
            self._shown_sign = sign
            self.query_one("#sign", Static).update(Content(sign))

    def _sign(self) -> str:
        return "dxl> " if self.session.assembling is None else f"step {len(self.session.assembling)}> "

    def _show_hint(self) -> None:
        line = self.query_one("#hint", Static)
        keys = fitting([self.say(f"hint.{key}") for key in ("tab", "up", "escape")], line.size.width)
        line.update(Content(hint(self.session, self.query_one(Prompt).value) or keys), layout=False)

    def _show_registers(self) -> None:
        self.query_one(Registers).put(holdings(self.session, self.servo), "<" if self.lab.ascii_only else "◂")

    def _show_condition(self) -> None:
        """Supply, speed and faults, and whether anybody can still answer."""
        line = self.query_one("#condition", Static)
        facts = conditions(self.session, self.servo, self.say, held=self.held)
        line.update(Content(fitting(facts, line.size.width, ", ")), layout=False)
        why = silence(self.session)
        if self.has_class("-silent") != bool(why):
            self.set_class(bool(why), "-silent")
            self.refresh_bindings()
        if why:
            self.query_one("#silence", Said).fill(why=self.say(f"silence.{why}"))

    def _tick(self) -> None:
        """Let the chain live on, and look at its registers."""
        now = time.monotonic()
        passed, self._seen = min(now - self._seen, LONGEST_TICK), now
        if self.held or not self.is_current:
            return
        elapse(self.session, passed)
        if self.query_one(Registers).region:
            self._show_registers()

    @on(Resize)
    def _resized(self) -> None:
        self.call_after_refresh(self._show_condition)
        self.call_after_refresh(self._show_hint)

    # What a person does.

    def carry_out(self, line: str) -> None:
        """Carry out a line of the sandbox, and show what it led to; a wrong one leaves all as it is."""
        if line.strip() in ("quit", "exit"):
            self.app.exit()
            return
        verb, _, rest = line.strip().partition(" ")
        if verb == "load" and rest:
            self.run_worker(self._carry_out_file(rest.strip()), group="script", exclusive=True)
            return
        before, done, wrong = self._chain(), [], ""
        try:
            for part in line.split(";"):
                done.append(execute(self.session, part))
        except KinlabError as error:
            wrong = str(error)
        self._show_done(done, wrong, before)

    async def _carry_out_file(self, name: str) -> None:
        """Carry out a file, line by line; whoever types meanwhile stops it."""
        self.tell("note", self.say("loading", file=name))
        before, done, wrong = self._chain(), [], self.say("stopped", file=name)
        try:
            for outcome in run_script(self.session, read_script(name)):
                done.append(outcome)
                await asyncio.sleep(0)
            wrong = ""
        except KinlabError as error:
            wrong = str(error)
        finally:
            if self.is_running:
                self._show_done(done, wrong, before)

    def _chain(self) -> tuple[str, list[int]]:
        return self.session.chain_text, self.session.ids()

    def _show_done(self, done: list[Outcome], wrong: str, before: tuple[str, list[int]]) -> None:
        """Show what lines led to.

        Args:
            wrong: what ended them; "" where they came to their end.
            before: the chain as it was.
        """
        lines = [line for outcome in done for line in outcome.lines]
        exchange = next((o.data["exchange"] for o in reversed(done) if "exchange" in o.data), None)
        if lines and (exchange or not wrong):
            self._lines = lines
        if wrong:
            self.tell("bad", wrong.splitlines()[0])
        elif lines:
            upshot = "".join(text for _, text in lines[-1]).strip()
            self.tell("good" if all(outcome.ok for outcome in done) else "bad", upshot)
        else:
            self.tell("good", self.say("done"))
        if before != self._chain():
            self._meet_chain()
        self.query_one(Traffic).put(self.session)
        self._show_registers()
        if exchange:
            self._follow(exchange)
        self._show_packet()
        self._show_hint()
        self._show_condition()
        self.refresh_bindings()

    def _follow(self, exchange: dict[str, Any]) -> None:
        """Look at the servo, and the register, that was spoken of."""
        if exchange["sent"]["id"] in self.session.ids():
            self._look_at(exchange["sent"]["id"])
            spoken = [f for packet in (exchange["sent"], *exchange["answers"]) for f in packet["fields"]]
            if name := next((f["register"] for f in spoken if "register" in f), ""):
                self.query_one(Registers).bring(name)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Send and back want bytes, revive a chain that is silent, and there is one view where all are shown."""
        match action:
            case "send" | "back":
                return True if self.session.assembling else None
            case "revive":
                return bool(silence(self.session))
            case "view":
                return not self.has_class("-wide")
        return True

    def action_assemble(self) -> None:
        """Begin a packet, or drop the one that is begun."""
        self._show("packet")
        self.carry_out("step" if self.session.assembling is None else "step off")
        self.query_one(Prompt).focus()

    def action_send(self) -> None:
        """Send the bytes that are assembled."""
        self._show("packet")
        self.carry_out("send")

    def action_back(self) -> None:
        """Take a byte back."""
        self.carry_out("step back")

    def action_faults(self) -> None:
        """Show the faults."""
        from kinlab.tui.stations.packet.faults import Faults

        self.app.push_screen(Faults(self))

    def action_view(self) -> None:
        """Go to the next view."""
        self._show(VIEWS[(VIEWS.index(self.view) + 1) % len(VIEWS)])

    def _show(self, view: str) -> None:
        self.view = view
        self._show_view()

    def action_next_servo(self) -> None:
        """Look at the next servo."""
        ids = self.session.ids()
        self._look_at(ids[(ids.index(self.servo) + 1) % len(ids)])

    def _look_at(self, servo: int) -> None:
        self.servo = servo
        self.query_one("#servo", Choice).put(self._named(servo))
        self._show_registers()
        self._show_condition()

    def action_next_chain(self) -> None:
        """Open the list of chains."""
        chains = self.query_one("#chain", Choice)
        chains.focus()
        chains.action_show_overlay()

    def action_line(self) -> None:
        """Go to the line."""
        self.query_one(Prompt).focus()

    def action_hold(self) -> None:
        """Stop the chain's time, or let it go on."""
        self.held = not self.held
        self._show_condition()

    def action_scroll(self, pages: int) -> None:
        """Scroll the packet."""
        sheet = self.query_one(Sheet)
        sheet.scroll_relative(y=pages * max(sheet.size.height - 1, 1), animate=False)

    def action_revive(self) -> None:
        """Power a silent chain on again, and mend its servos."""
        for line in revival(self.session):
            self.carry_out(line)
        self.tell("good", self.say("revived"))

    # What the widgets tell.

    @on(Prompt.Entered)
    def _entered(self, event: Prompt.Entered) -> None:
        self.workers.cancel_group(self, "script")
        if event.line.strip():
            self._show("packet")
            self.carry_out(event.line)
        elif self.session.assembling:
            self.action_send()

    @on(Prompt.Back)
    def _taken_back(self) -> None:
        if self.session.assembling:
            self.action_back()

    @on(Prompt.Offered)
    def _offered(self, event: Prompt.Offered) -> None:
        words = [f"[{text}]" if text == event.chosen else text for text in event.found]
        self.query_one("#hint", Static).update(Content("  ".join(words)), layout=False)

    @on(Input.Changed, "Prompt")
    def _typed(self) -> None:
        self._show_packet()
        self._show_hint()

    @on(Select.Changed, "#chain")
    def _other_chain(self, event: Select.Changed) -> None:
        # A list tells of its first value as well, when that may have changed already.
        if event.value != event.select.value or event.value == self.session.chain_text:
            return
        self.carry_out(f"chain {event.value}")
        self._lines = None
        self._show_packet()
        self.query_one(Prompt).focus()

    @on(Select.Changed, "#servo")
    def _other_servo(self, event: Select.Changed) -> None:
        if event.value == event.select.value:
            self._look_at(int(str(event.value).split()[0]))

    @on(Tabs.Chosen)
    def _other_view(self, event: Tabs.Chosen) -> None:
        self._show(event.name)

    @on(Registers.Chosen)
    def _change(self, event: Registers.Chosen) -> None:
        register, value = event.holding.register, str(event.holding.ticks)
        if register.writable:
            self.query_one(Prompt).put(f"write {self.servo} {register.name} {value}", len(value))
        else:
            self.query_one(Prompt).put(f"read {self.servo} {register.name}")
            self.tell("note", self.say("read_only", register=register.name, servo=self.servo))

    @on(Traffic.Chosen)
    def _look_back(self, event: Traffic.Chosen) -> None:
        self._lines = exchange_lines(self.session, event.exchange)
        self._show("packet")
        self._show_packet()
        self.tell("note", self.say("looked_back", bytes=show_hex(event.exchange.sent)))

    @on(Click, "#silence")
    def _clicked(self) -> None:
        self.action_revive()
