"""What is left behind when KinLab itself fails: a report for those who mend it."""

import platform
import time
import traceback
from pathlib import Path

import kinlab


def write_report(error: BaseException, folder: Path) -> Path | None:
    """A file with what happened where, in which versions; None where none can be written."""
    import textual

    path = folder / time.strftime("crash-%Y%m%d-%H%M%S.txt")
    text = "\n".join(
        [
            f"kinlab {kinlab.__version__}, textual {textual.__version__}",
            f"Python {platform.python_version()}, {platform.platform()}",
            "",
            "".join(traceback.format_exception(error)),
        ]
    )
    # Whose machine it is, is nobody's business who mends KinLab.
    text = text.replace(str(Path.home()), "~")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    except OSError:
        return None
    return path
