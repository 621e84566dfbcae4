"""The printed tables: what a file may hold, and what it says."""

import pytest

from kinlab.papers import tables
from kinlab.papers.tables import printed_table, printed_tables


@pytest.fixture
def write(tmp_path, monkeypatch):
    """Write a table of a paper of our own."""
    monkeypatch.setattr(tables, "HERE", tmp_path)
    (tmp_path / "ours").mkdir()
    tables.printed_table.cache_clear()
    yield lambda number, text: (tmp_path / "ours" / f"table-{number}.csv").write_text(text)
    tables.printed_table.cache_clear()


def test_a_table_has_figures_under_names_with_units(write):
    write("1", "# what it holds\nleg,test,x [mm],share []\nleft,1,2.50,3\nleft,2,,4?\naverage,,2.5,3.5 %\n")
    table = printed_table("ours", "1")
    assert table.title == "what it holds"
    assert table.units == {"x": "mm", "share": ""}
    assert list(table.rows) == ["left test 1", "left test 2", "average"]
    assert table.runs == ["left test 1", "left test 2"]
    assert [cell.where for cell in table.cells()] == [
        "Table 1 left test 1 x",
        "Table 1 left test 1 share",
        "Table 1 left test 2 share",
        "Table 1 average x",
        "Table 1 average share",
    ]
    assert table.column("share").tolist() == [3, 4]
    assert table.rows["left test 2"]["share"].figure.damaged
    assert table.rows["average"]["share"].unit == "%"
    assert [cell.figure.text for cell in table.cells("x")] == ["2.50"]


def test_a_wrong_cell_is_named(write):
    write("1", "# t\ntest,x [mm]\n1,2,5\n")
    with pytest.raises(ValueError, match="zip"):
        printed_table("ours", "1")
    write("2", "# t\ntest,x [mm]\n1,two\n")
    with pytest.raises(ValueError, match=r"table-2\.csv: test 1 x: 'two' is no printed number"):
        printed_table("ours", "2")


def test_two_rows_of_one_name_are_refused(write):
    write("1", "# t\ntest,x [mm]\n1,2\n1,3\n")
    with pytest.raises(ValueError, match="two rows are named 'test 1'"):
        printed_table("ours", "1")


def test_tables_come_in_the_order_of_their_numbers(write):
    for number in ("10", "2", "2.10", "2.2"):
        write(number, "# t\ntest,x []\n1,2\n")
    assert [table.number for table in printed_tables("ours")] == ["2", "2.2", "2.10", "10"]


# The sum of all figures of a table, taken when they were compared with the print, digit by digit.
COMPARED = {
    "xl430-hexapod": {
        "1": 2530.86, "2": 315, "3": 309, "4": 31.22, "5": 647.16, "6": 666.6, "7": 24, "8": 37.32, "9": 29.4,
        "10": 95.64,
    },
    "krsri-hexapod": {"1": 0, "2": 1906.338, "3": 4082.3, "4": 1906.691, "5": 3876.2},
    "udiebot-quadruped": {"1": 1115.66, "2": 360, "3": 25, "4": 1.132, "5": 289.464, "6": 288.511},
    "eros-humanoid": {"1": 40, "2": 3, "3": 6, "4": 6, "5": 14, "6": 14, "7": 152, "8": 164},
    "receptionist-arm": {
        "2.1": 4994, "2.2": 2424653.056, "2.3": 3, "2.4": 1784, "2.5": 81, "2.6": 27, "2.7": 28, "2.8": 22, "2.9": 28,
        "2.10": 6, "4.1": 18.3,
    },
}  # fmt: skip


@pytest.mark.parametrize("paper", COMPARED)
def test_figures_are_those_that_were_compared_with_the_print(paper):
    """Most wrong digits change a verdict; one in what was measured, and is averaged nowhere, would change nothing."""
    sums = {table.number: sum(cell.figure.value for cell in table.cells()) for table in printed_tables(paper)}
    assert sums == pytest.approx(COMPARED[paper], abs=1e-6)
