"""The command line, run in this process."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pytest

from kinlab.cli import main


@dataclass(frozen=True)
class Run:
    """What a command printed and how it ended."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        """Standard output as one JSON document; NaN and infinities are refused, as they are not JSON."""

        def refuse(constant: str) -> Any:
            raise AssertionError(f"{constant} is not JSON")

        return json.loads(self.out, parse_constant=refuse)


@pytest.fixture
def kinlab(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Callable[..., Run]:
    """`kinlab("ik", "udiebot", 26, 0, 10)` as a shell would run it, on a wide terminal without colours."""
    monkeypatch.setenv("COLUMNS", "140")
    for name in ("KINLAB_ROBOTS", "KINLAB_LESSONS", "LANGUAGE"):
        monkeypatch.delenv(name, raising=False)

    def run(*args: Any) -> Run:
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            main([str(a) for a in args])
        printed = capsys.readouterr()
        code = ended.value.code
        assert "Traceback" not in printed.err
        return Run(code if isinstance(code, int) else 0, printed.out, printed.err)

    return run
