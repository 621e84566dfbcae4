"""Drawing with characters."""

from kinlab.canvas import Canvas, chart


def _square(**settings: bool) -> Canvas:
    return Canvas(20, 10, [(-10.0, -10.0), (10.0, 10.0)], **settings)


def test_one_scale_serves_both_directions():
    """A square of the world is as many dots wide as high: half as many columns as dots, a quarter of the rows."""
    canvas = _square()
    for a, b in ((-10, -10, 10, -10), (-10, 10, 10, 10)), ((-10, -10, -10, 10), (10, -10, 10, 10)):
        for x0, y0, x1, y1 in (a, b):
            canvas.line((x0, y0), (x1, y1), "edge")
    rows = [row for row in canvas.text().splitlines() if row.strip()]
    assert abs(2 * max(map(len, (r.strip() for r in rows))) - 4 * len(rows)) <= 4


def test_what_must_be_in_sight_is():
    canvas = Canvas(30, 8, [(0.0, 0.0), (1000.0, 3.0)])
    canvas.mark((0.0, 0.0), "A", "")
    canvas.mark((1000.0, 3.0), "B", "")
    assert "A" in canvas.text()
    assert "B" in canvas.text()


def test_places_out_of_sight_are_left_out():
    canvas = _square()
    canvas.mark((1e6, 0.0), "A", "")
    canvas.label((1e6, 0.0), "far", "")
    canvas.line((-1e3, 0.0), (1e3, 0.0), "line")
    assert "A" not in canvas.text()
    assert "far" not in canvas.text()


def test_up_is_up_and_right_is_right():
    canvas = _square()
    canvas.mark((0.0, 9.0), "U", "")
    canvas.mark((9.0, 0.0), "R", "")
    rows = canvas.text().splitlines()
    up = next(i for i, row in enumerate(rows) if "U" in row)
    right = next(i for i, row in enumerate(rows) if "R" in row)
    assert up < right
    assert rows[right].index("R") > rows[up].index("U")


def test_labels_never_cover_marks_or_each_other():
    canvas = _square()
    canvas.mark((0.0, 0.0), "o", "")
    for _ in range(8):
        canvas.label((0.0, 0.0), "name", "")
    text = canvas.text()
    assert "o" in text
    assert 1 <= text.count("name") <= 4


def test_two_labels_never_read_as_one():
    canvas = _square()
    canvas.label(canvas.place(9, 4), "femur", "")
    canvas.label(canvas.place(5, 4), "coxa", "")
    assert "coxafemur" not in canvas.text()
    assert canvas.text().count("coxa") == 1


def test_a_label_may_stand_on_the_left_first():
    for left, text in ((False, "o name"), (True, "name o")):
        canvas = _square()
        canvas.mark((0.0, 0.0), "o", "")
        canvas.label((0.0, 0.0), "name", "", left=left)
        assert text in canvas.text()


def test_ascii_only_needs_no_braille():
    canvas = _square(ascii_only=True)
    canvas.line((-9.0, -9.0), (9.0, 9.0), "line")
    assert canvas.text().isascii()
    assert "*" in canvas.text()


def test_empty_places_are_spaces_and_not_blank_braille():
    canvas = _square()
    canvas.line((-9.0, 0.0), (9.0, 0.0), "line")
    assert "\u2800" not in canvas.text()


def test_spans_carry_the_roles_that_a_face_colours():
    canvas = _square()
    canvas.line((-9.0, 0.0), (9.0, 0.0), "femur")
    assert {role for row in canvas.spans() for _, role in row} == {"", "femur"}


def test_fill_covers_what_is_inside():
    canvas = _square()
    canvas.fill(lambda x, y: x * x + y * y < 25, "disc")
    full = sum(text.count("⣿") for row in canvas.spans() for text, _ in row)
    # The disc's area in characters, which are cell_width by twice that.
    area = 25 * 3.1416 / (canvas.cell_width * 2 * canvas.cell_width)
    assert 0.5 * area < full <= area


def test_a_picture_of_a_single_point_is_possible():
    canvas = Canvas(10, 5, [(3.0, 3.0)])
    canvas.mark((3.0, 3.0), "x", "")
    assert "x" in canvas.text()


def test_a_chart_names_its_curves_and_spans_their_ranges():
    rising = [(float(i), float(i)) for i in range(10)]
    falling = [(float(i), 9.0 - i) for i in range(10)]
    canvas, across, up = chart({"up": rising, "down": falling}, 60, 9)
    assert across == (0.0, 9.0)
    assert up == (0.0, 9.0)
    rows = canvas.text().splitlines()
    assert next(i for i, row in enumerate(rows) if "up" in row) < next(
        i for i, row in enumerate(rows) if "down" in row
    )


def test_a_gap_in_a_curve_stays_a_gap():
    whole, _, _ = chart({"a": [(0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (3.0, 1.0)]}, 40, 5)
    broken, _, _ = chart({"a": [(0.0, 1.0), (1.0, float("nan")), (2.0, 1.0), (3.0, 1.0)]}, 40, 5)
    assert len(broken.text().replace(" ", "")) < len(whole.text().replace(" ", ""))


def test_a_flat_curve_and_a_single_point_are_possible():
    for points in ([(0.0, 0.0), (1.0, 0.0)], [(2.0, 5.0)]):
        canvas, _, _ = chart({"a": points}, 30, 5)
        assert "a" in canvas.text()


def test_a_character_tells_the_place_in_its_middle():
    canvas = _square()
    for row, column in ((0, 0), (3, 11), (9, 19)):
        canvas = _square()
        canvas.mark(canvas.place(column, row), "X", "")
        assert canvas.text().splitlines()[row][column] == "X"


def test_a_chart_far_from_zero_may_leave_it_out():
    points = [(0.0, 100.0), (1.0, 101.0)]
    assert chart({"a": points}, 40, 6)[2] == (0.0, 101.0)
    canvas, _, up = chart({"a": points}, 40, 6, zero=False)
    assert up == (100.0, 101.0)
    assert "axis" not in {role for row in canvas.spans() for _, role in row}


def test_the_place_of_a_character_is_where_a_mark_at_it_stands():
    canvas = _square()
    x, y = canvas.place(14, 2)
    canvas.mark((x, y), "X", "")
    row = canvas.text().splitlines()[2]
    assert row.index("X") == 14


def test_an_outline_is_the_edge_of_a_region_and_nothing_of_its_inside():
    outlined, filled = _square(), _square()
    outlined.outline(lambda xs, ys: [[x * x + y * y < 64 for x in xs] for y in ys], "edge")
    filled.fill(lambda x, y: x * x + y * y < 64, "disc")
    inside = canvas_dots(filled)
    edge = canvas_dots(outlined)
    assert edge < inside
    for x, y in edge:
        assert not {(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)} <= inside
    for x, y in inside - edge:
        assert {(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)} <= inside


def test_a_thick_line_is_two_dots_wide():
    thin, thick = _square(), _square()
    for canvas, settings in ((thin, {}), (thick, {"thick": True})):
        canvas.line((-9.0, 0.0), (9.0, 0.0), "line", **settings)
    assert len(canvas_dots(thick)) == 2 * len(canvas_dots(thin))


def canvas_dots(canvas: Canvas) -> set[tuple[int, int]]:
    """The dots that are set, by column and row, read back from the braille."""
    weights = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
    return {
        (2 * c + dx, 4 * r + dy)
        for r, row in enumerate(canvas.text().splitlines())
        for c, char in enumerate(row)
        for dy in range(4)
        for dx in range(2)
        if char != " " and ord(char) - 0x2800 & weights[dy][dx]
    }


def test_what_is_written_under_a_chart_stands_below_its_place():
    points = [(0.0, 0.0), (10.0, 0.0), (20.0, 5.0)]
    canvas, _, _ = chart({"a": points}, 40, 6, ascii_only=True, marks={0.0: "0", 20.0: "20 s"})
    *curve, written = canvas.text().splitlines()
    assert written.split() == ["0", "20", "s"]
    assert written.index("20") == max(line.rfind("*") for line in curve)
