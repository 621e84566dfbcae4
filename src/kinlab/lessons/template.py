"""A new lesson to begin from: whole, in both languages, and free of lint."""

import re
import shutil
from pathlib import Path

from kinlab.errors import FileError, UsageError
from kinlab.files import write_whole
from kinlab.lessons.format import ID

ENGLISH = """\
+++
title = "A title that asks or promises something"
goals = ["what the student can do afterwards"]
version = 1
minutes = 10
order = 1000
robot = "xl430-hexapod"
prerequisites = ["leg-geometry"]

[params]
beta = { from = 10, to = 45, step = 5 }
gamma = { from = -110, to = -70, step = 5 }
+++

# The question that the lesson answers

Say what the student sees or wants, in a few sentences, and let them try before you explain.

```figure
id = "leg"
draw = "leg.side"
alt = "The leg from the side, its femur raised by {beta} degrees."
with = { alpha = 0 }
```

```exercise
id = "height"
kind = "number"
unit = "mm"
tolerance = 0.5
ask = "The femur stands at {beta}°, the knee at {gamma}°. How high is the foot over the coxa?"
hints = [
    "The idea: which links take you up, and which down?",
    "The method: each link rises by its length times the sine of its angle to the horizontal.",
    "The formula: h = f sin(beta) + t sin(beta + gamma)",
]
solution = "h = {answer:.1f} mm"
answer = "leg.height"

[feedback]
sign = "The foot hangs below the coxa: its height is negative."
```

End with something that they can use on a real robot.
"""

INDONESIAN = """\
+++
title = "Judul yang bertanya atau menjanjikan sesuatu"
goals = ["apa yang bisa dilakukan mahasiswa sesudahnya"]
+++

# Pertanyaan yang dijawab pelajaran ini

Ceritakan dalam beberapa kalimat apa yang dilihat atau diinginkan mahasiswa, dan biarkan ia mencoba dulu.

```figure
id = "leg"
alt = "Kaki dilihat dari samping, femurnya terangkat {beta} derajat."
```

```exercise
id = "height"
ask = "Femur bersudut {beta}°, lutut {gamma}°. Berapa tinggi ujung kaki di atas coxa?"
hints = [
    "Gagasannya: ruas mana yang membawamu naik, dan mana yang turun?",
    "Caranya: setiap ruas naik sejauh panjangnya kali sinus sudutnya terhadap garis mendatar.",
    "Rumusnya: h = f sin(beta) + t sin(beta + gamma)",
]
solution = "h = {answer:.1f} mm"

[feedback]
sign = "Ujung kaki menggantung di bawah coxa: tingginya negatif."
```

Akhiri dengan sesuatu yang bisa dipakai pada robot sungguhan.
"""


def new_lesson(name: str, folder: Path) -> list[Path]:
    """Write the template as lesson `name` into `folder`; the files that were made.

    Raises:
        UsageError: no name for a lesson.
        FileError: it is there already, or cannot be written.
    """
    if not re.fullmatch(ID, name):
        raise UsageError(
            f"'{name:.70}' is no name for a lesson: small letters, digits and hyphens, as in my-lesson"
        )
    home = folder / name
    if home.exists():
        raise FileError(f"{home}: is there already; nothing was changed")
    try:
        home.mkdir(parents=True)
    except OSError as error:
        raise FileError(f"{home}: cannot be made: {error.strerror}") from None
    made = []
    for code, text in (("en", ENGLISH), ("id", INDONESIAN)):
        path = home / f"{code}.md"
        try:
            write_whole(path, text)
        except FileError:
            # On a full disk nothing half is left, which would be in the way of the next attempt.
            shutil.rmtree(home, ignore_errors=True)
            raise
        made.append(path)
    return made
