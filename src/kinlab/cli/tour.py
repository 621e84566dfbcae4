"""`kinlab tour`: the whole path once, printed: the first thing to run."""

from kinlab.cli.command import JsonOption, NumericCommand, command_app, print_json

app = command_app()


@app.command(cls=NumericCommand, epilog="Example: kinlab tour")
def tour(json: JsonOption = False) -> None:
    """The whole path once, for one target of each of the five papers.

    From a target to joint angles, servo angles, ticks and the bytes of the sync
    write, and back from where emulated servos then stand, with the error at
    each depth.
    """
    from kinlab.papers.tour import tour as walk

    stops = walk()
    if json:
        print_json({"stops": [stop.to_json() for stop in stops]})
        return
    from kinlab.cli.tour_tables import show_tour

    show_tour(stops)
