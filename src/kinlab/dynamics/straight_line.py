"""The equations of one mechanism as straight-line code on plain numbers, for simulators that take one state at a time.

The recursion is run once on terms that write down what is done to them. What comes of it, without zeros,
twice-computed terms and loops, takes microseconds for a state where numpy's arrays take a hundred.
"""

from collections.abc import Callable, Sequence
from math import cos, sin
from typing import Any

from kinlab.dynamics.mechanism import Mechanism
from kinlab.dynamics.newton_euler import Contact, Load, newton_euler
from kinlab.kinematics.columns import ZERO

Function = Callable[..., tuple[float, ...]]


class _Tape:
    """The lines written so far, each once."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}

    def term(self, text: str) -> "_Term":
        return _Term(self, self.names.setdefault(text, f"t{len(self.names)}"))


class _Term:
    """A value that is not known yet."""

    __slots__ = ("name", "tape")

    def __init__(self, tape: _Tape, name: str) -> None:
        self.tape, self.name = tape, name

    def _with(self, sign: str, other: Any, turned: bool = False) -> "_Term":
        a, b = self.name, other.name if isinstance(other, _Term) else repr(float(other))
        if sign in "+*" and b < a:
            turned = not turned  # so that both orders are one line
        return self.tape.term(f"{b} {sign} {a}" if turned else f"{a} {sign} {b}")

    def __add__(self, other: Any) -> "_Term":
        return self._with("+", other)

    def __sub__(self, other: Any) -> "_Term":
        return self._with("-", other)

    def __rsub__(self, other: Any) -> "_Term":
        return self._with("-", other, turned=True)

    def __mul__(self, other: Any) -> "_Term":
        return self._with("*", other)

    def __neg__(self) -> "_Term":
        return self.tape.term(f"-{self.name}")

    __radd__, __rmul__ = __add__, __mul__


def _function(inputs: Sequence[str], tape: _Tape, outputs: Sequence[Any]) -> Function:
    results = [o.name if isinstance(o, _Term) else repr(float(o)) for o in outputs]
    by_name = {name: text for text, name in tape.names.items()}
    wanted, waiting = set(), list(results)
    while waiting:
        name = waiting.pop()
        if name in by_name and name not in wanted:
            wanted.add(name)
            waiting += by_name[name].replace("(", " ").replace(")", " ").replace("-", " ").split()
    lines = [f"    {name} = {text}" for text, name in tape.names.items() if name in wanted]
    code = "\n".join([f"def f({', '.join(inputs)}):", *lines, f"    return ({', '.join(results)},)"])
    space: dict[str, Any] = {"sin": sin, "cos": cos}
    exec(compile(code, "<equations of motion>", "exec"), space)
    function: Function = space["f"]
    return function


def _inputs(tape: _Tape, mechanism: Mechanism, *letters: str) -> tuple[list[str], list[list[_Term]]]:
    names = [[f"{letter}{i}" for i in range(mechanism.count)] for letter in letters]
    q = [_Term(tape, name) for name in names[0]]
    sines, cosines = ([tape.term(f"{f}({x.name})") for x in q] for f in ("sin", "cos"))
    rest = [[_Term(tape, name) for name in row] for row in names[1:]]
    return [name for row in names for name in row], [q, sines, cosines, *rest]


def inverse_equations(mechanism: Mechanism) -> Function:
    """f(q..., qd..., qdd...): the torques, as `inverse_dynamics` has them."""
    tape = _Tape()
    names, (q, s, c, qd, qdd) = _inputs(tape, mechanism, "q", "v", "a")
    return _function(names, tape, newton_euler(mechanism, q, s, c, qd, qdd))


def motion_equations(mechanism: Mechanism) -> Function:
    """f(q..., qd...): the n x n mass matrix, row by row, then the torques that hold qdd at zero."""
    tape, n = _Tape(), mechanism.count
    names, (q, s, c, qd) = _inputs(tape, mechanism, "q", "v")
    still = newton_euler(mechanism, q, s, c, qd, [0.0] * n)
    columns = [
        newton_euler(mechanism, q, s, c, [0.0] * n, [float(i == j) for i in range(n)], weight=0.0)
        for j in range(n)
    ]
    # The lower half computes as the upper one does, in other words: one of them is enough.
    matrix = [columns[max(i, j)][min(i, j)] for i in range(n) for j in range(n)]
    return _function(names, tape, [*matrix, *still])


def contact_equations(mechanism: Mechanism, at: Contact) -> Function:
    """f(q..., fx, fy, fz): the torques that a force in N, base frame, at a point of the chain has on the joints."""
    tape, rest = _Tape(), [0.0] * mechanism.count
    names, (q, s, c) = _inputs(tape, mechanism, "q")
    force = [_Term(tape, axis) for axis in ("fx", "fy", "fz")]
    against = newton_euler(mechanism, q, s, c, rest, rest, Load(force, ZERO, at), weight=0.0)
    return _function([*names, "fx", "fy", "fz"], tape, [-x for x in against])
