"""Vectors as three columns: arrays of many poses, plain numbers, or terms of a formula; all alike.

A component that is the plain number 0.0 or 1.0 costs no arithmetic: the zeros of a robot's own axes and
of joints at rest drop out of whole columns.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

Column = Any  # an array (N,), a float, or whatever else adds and multiplies
Vector = list[Column]
ZERO: Vector = [0.0, 0.0, 0.0]


def product(a: Column, b: Column) -> Column:
    """a b."""
    if isinstance(a, float):
        a, b = b, a
    if isinstance(b, float):
        return 0.0 if b == 0.0 else a if b == 1.0 else -a if b == -1.0 else a * b
    return a * b


def plus(a: Column, b: Column) -> Column:
    """a + b."""
    if isinstance(a, float) and a == 0.0:
        return b
    if isinstance(b, float) and b == 0.0:
        return a
    return a + b


def minus(a: Column, b: Column) -> Column:
    """a - b."""
    if isinstance(b, float) and b == 0.0:
        return a
    if isinstance(a, float) and a == 0.0:
        return -b
    return a - b


def add(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    total = vectors[0]
    for v in vectors[1:]:
        total = [plus(a, b) for a, b in zip(total, v, strict=True)]
    return total


def scale(v: Vector, factor: Column) -> Vector:
    """`v` times `factor`."""
    return [product(factor, c) for c in v]


def dot(u: Vector, v: Vector) -> Column:
    """u . v."""
    return plus(plus(product(u[0], v[0]), product(u[1], v[1])), product(u[2], v[2]))


def cross(u: Vector, v: Vector) -> Vector:
    """u x v."""
    return [
        minus(product(u[1], v[2]), product(u[2], v[1])),
        minus(product(u[2], v[0]), product(u[0], v[2])),
        minus(product(u[0], v[1]), product(u[1], v[0])),
    ]


def turn(axis: Sequence[float], sine: Column, cosine: Column, v: Vector) -> Vector:
    """`v` turned about the unit vector `axis` by the angle with that sine and cosine (Rodrigues' formula)."""
    main = int(np.argmax(np.abs(axis)))
    if abs(axis[main]) == 1.0:
        j, k = (main + 1) % 3, (main + 2) % 3
        s = sine if axis[main] > 0 else -sine
        turned = list(v)
        turned[j] = minus(product(cosine, v[j]), product(s, v[k]))
        turned[k] = plus(product(s, v[j]), product(cosine, v[k]))
        return turned
    a = [float(c) for c in axis]
    along = product(1.0 - cosine, dot(a, v))
    return add(scale(v, cosine), scale(cross(a, v), sine), scale(a, along))
