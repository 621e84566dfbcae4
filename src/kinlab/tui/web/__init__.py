"""The TUI in browsers: what `kinlab serve` runs.

Of textual-serve this uses the page's terminal (a script and a font) and its way of talking to a process. What it
leaves open is closed here: who may connect (`gate`), how many, under which folder each works, that nothing is asked
from another machine, and that a process can have the browser open nothing. In the process, `kinlab.guests` refuses
what a guest must not do.
"""
