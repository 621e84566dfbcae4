"""Registers of many servos, round after round, and as CSV."""

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

from kinlab.dynamixel.bus import Bus, BusError
from kinlab.dynamixel.tables import Register
from kinlab.errors import FileError, UsageError

NOT_WATCHED = ("present_pwm",)


@dataclass(frozen=True)
class Round:
    """What all servos said at about one time.

    Attributes:
        time: s since the monitor began.
        values: by servo and register, in the register's unit; None where no answer came.
        faults: of servos that did not answer or report alarms, in words.
    """

    time: float
    values: dict[int, dict[str, float | None]]
    faults: dict[int, str]

    def as_json(self) -> dict[str, Any]:
        """As the command line prints it."""
        servos = [{"id": i, **row, "fault": self.faults.get(i)} for i, row in self.values.items()]
        return {"time_s": round(self.time, 6), "servos": servos}


class Monitor:
    """Reads the same registers of the same servos again and again.

    Attributes:
        columns: names of the values with their units ("present_position_deg").
    """

    def __init__(self, bus: Bus, servos: Sequence[int], names: Sequence[str] | None, rate: float) -> None:
        """Set up.

        Args:
            names: registers; None: those that are measured.
            rate: rounds per second.

        Raises:
            UsageError: no servos, an unknown register, a rate that is none.
            BusError: a servo does not answer.
        """
        if not servos:
            raise UsageError("there is no servo to watch")
        if not 0 < rate <= 1000:
            raise UsageError(f"the rate goes up to 1000 rounds per second and is more than 0, not {rate}")
        self._bus = bus
        self._period = 1 / rate
        self._registers = {servo: self._chosen(servo, names) for servo in servos}
        self.columns = list(dict.fromkeys(column(r) for chosen in self._registers.values() for r in chosen))

    def _chosen(self, servo: int, names: Sequence[str] | None) -> list[Register]:
        if names:
            return [self._bus.register(servo, name) for name in names]
        # A servo without a table is answered for by `register`.
        self._bus.register(servo, "id")
        table = self._bus.known(servo).table
        assert table is not None
        return [r for r in table.registers if r.name.startswith("present_") and r.name not in NOT_WATCHED]

    def rounds(self, count: int | None = None) -> Iterator[Round]:
        """Round after round, `count` times or for ever.

        Raises:
            PortError: the port is gone.
        """
        clock = self._bus.port.clock
        start = clock.now()
        done = 0
        while count is None or done < count:
            yield self._round(clock.now() - start)
            done += 1
            clock.wait(start + done * self._period - clock.now())

    def _round(self, time: float) -> Round:
        values: dict[int, dict[str, float | None]] = {}
        faults: dict[int, str] = {}
        for servo, registers in self._registers.items():
            try:
                ticks = self._bus.read_block(servo, registers)
            except BusError as error:
                faults[servo] = error.cause
                values[servo] = {column(r): None for r in registers}
                continue
            values[servo] = {column(r): round(r.physical(ticks[r.name]), 6) for r in registers}
            if servo in self._bus.alarms:
                faults[servo] = ", ".join(self._bus.alarms[servo])
        return Round(time, values, faults)


def column(register: Register) -> str:
    """A register's name with its unit."""
    return f"{register.name}_{register.unit}" if register.unit else register.name


class CsvLog:
    """Rounds as rows of a CSV file, on disk as they come."""

    def __init__(self, path: Path, monitor: Monitor) -> None:
        """Begin the file.

        Raises:
            FileError: it cannot be written.
        """
        self._path = path
        self._columns = monitor.columns
        try:
            self._file = path.open("w", encoding="utf-8", newline="", buffering=1)
            self._rows = csv.writer(self._file, lineterminator="\n")
            self._rows.writerow(["time_s", "id", *self._columns, "fault"])
        except OSError as error:
            raise FileError(f"{path}: cannot be written: {error.strerror}") from None

    def __enter__(self) -> "CsvLog":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._file.close()

    def add(self, seen: Round) -> None:
        """A row for each servo."""
        try:
            for servo, row in seen.values.items():
                cells = [row.get(name) for name in self._columns]
                self._rows.writerow([f"{seen.time:.6f}", servo, *cells, seen.faults.get(servo, "")])
        except OSError as error:
            raise FileError(f"{self._path}: cannot be written: {error.strerror}") from None
