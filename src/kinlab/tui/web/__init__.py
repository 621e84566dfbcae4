"""The TUI in browsers: what `kinlab serve` runs.

Of textual-serve this uses the page's terminal (a script and a font) and the pump between a websocket and a
process. What it leaves open is closed here: who may connect (`gate`), how many, under which folder each works,
and that nothing is asked from another machine. In the process, `kinlab.guests` refuses what a guest must not do.
"""
