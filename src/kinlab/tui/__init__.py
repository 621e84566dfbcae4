"""The terminal laboratory that a bare `kinlab` opens. It asks the core and shows its answers; it computes nothing.

A station is a screen of its own, a package `stations/NAME/` with its words beside it:

- `stations/__init__.py` names it in `STATIONS`; from there come its key (F2 onwards, and its digit), its place in the
  bar, and its entry in the palette. A station is imported when it is first opened.
- It derives from `kinlab.tui.station.Station`, sets `NAME`, lists its `ACTIONS`, and yields its widgets from
  `compose_body`. The base class brings the bar, the message line, the line of keys, the help, and the notice that a
  terminal is too small.
- An `Action` is declared once and serves key, line of keys, palette and help. Its texts stand in the station's
  `words.toml` as `action.ID.label` (a word or two) and `action.ID.help` (a sentence). It runs the method
  `action_ID`; `check_action` may say that it cannot be used now (None) or does not exist now (False), and
  `refresh_bindings` tells that this has changed.
- Texts are never written in code. `self.say("key", value=...)` looks into the station's words, then into the shell's;
  the widget `Said("key")` shows such a text and follows the language. What a station sets by hand it sets again in
  `relabel`. Data reaches a widget as `Content` or with markup off, as brackets would vanish otherwise.
- `self.tell(kind, text)` puts a sentence on the message line; kinds are good, note, warn and bad, and each has a sign,
  as colour alone tells nothing. Errors beside a field are the field's own (`NumberField`); the last good state stays.
- `ready` begins; `on_mount` is the shell's. Textual calls a handler `on_...` of every base class by itself.
- `state` gives what is kept until the next run, `restore` takes it back and must not trust it.
- Long work runs in a worker (`@work(thread=True, exclusive=True, exit_on_error=False)`), asks whether it is
  cancelled, and hands results over by `self.app.call_from_thread`.
- Widths: the classes `-narrow` (below 80 columns), `-normal` and `-wide` (from 120), and `-low` (below 30 rows) and
  `-tall` stand on the screen for its CSS. Nothing is cut at 80 x 24, and 60 x 20 can be worked with.

Keys: ones that terminals and multiplexers leave alone. While a field has the focus, letters and digits are typed, so
that an action needed there has a function key or one with Ctrl as well. Reserved by the shell: F1 and ?, F2 to F6 and
1 to 5, Ctrl-N, Ctrl-P, Ctrl-T, Ctrl-L, Ctrl-Z, Ctrl-Q, Ctrl-C, Tab; Escape leaves the field that has the focus.
Ctrl-N, Ctrl-T and Ctrl-W never reach a session in a browser: nothing may depend on them alone.

Widgets to build from: `Picture` (a canvas by a function of its size; posts `Pointed` with places of the drawing),
`Plot` (curves), `Dial` (label, slider and number in one row; posts `Changed`), `NumberField`, `Slider`, `Choice`
(a list to choose from), `Said`. A dial's slider is for the mouse; arrows up and down turn its field.
"""
