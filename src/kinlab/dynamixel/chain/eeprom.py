"""The chain's EEPROM in a file, for a chain that outlives the program."""

import json
from pathlib import Path

from kinlab.dynamixel.chain.chain import Chain
from kinlab.errors import FileError, UsageError
from kinlab.files import write_whole


def save_eeprom(chain: Chain, path: Path) -> None:
    """Write what outlives a power cycle; the file is whole at every moment."""
    servos = [{"model": servo.table.model, "eeprom": servo.memory.eeprom()} for servo in chain.servos]
    write_whole(path, json.dumps({"servos": servos}, indent=1) + "\n")


def load_eeprom(chain: Chain, path: Path) -> None:
    """Give the chain's servos what an earlier one stored; a file that is not there yet changes nothing.

    Raises:
        FileError: it is no such file, or of another chain.
    """
    if not path.exists():
        return
    try:
        stored = json.loads(path.read_text(encoding="utf-8"))["servos"]
        if [entry["model"] for entry in stored] != [servo.table.model for servo in chain.servos]:
            raise FileError(f"{path}: holds the EEPROM of another chain")
        for servo, entry in zip(chain.servos, stored, strict=True):
            servo.restore({str(name): int(value) for name, value in entry["eeprom"].items()})
    except (OSError, ValueError, KeyError, TypeError, AttributeError, UsageError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError(f"{path}: is no EEPROM file of a chain ({error})") from None
    chain.take_census()
