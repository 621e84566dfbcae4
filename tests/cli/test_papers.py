"""`kinlab papers`: the contract, what people read, and the page."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest

from kinlab.papers.recompute import PAPERS, VERDICTS, xl430_hexapod

FINDING = {"paper", "where", "printed", "recomputed", "unit", "verdict", "cause"}


def test_json_holds_the_contract(kinlab):
    answer = kinlab("papers", "--json")
    assert (answer.code, answer.err) == (0, "")
    found = answer.json
    assert {finding["paper"] for finding in found["findings"]} == set(PAPERS)
    assert all(set(finding) >= FINDING for finding in found["findings"])
    assert {finding["verdict"] for finding in found["findings"]} == set(VERDICTS)
    assert all(c["recomputed"] == c["cells"] for c in found["coverage"].values())
    xl430 = [finding for finding in found["findings"] if finding["paper"] == "xl430-hexapod"]
    (cell,) = [finding for finding in xl430 if finding["where"] == "Table 4 test 8 y"]
    assert (cell["printed"], cell["recomputed"], cell["unit"], cell["verdict"]) == (
        2,
        3,
        "mm",
        "contradicted",
    )
    assert cell["arithmetic"] == "|15 - 18| = 3"


def test_without_a_name_it_counts(kinlab):
    answer = kinlab("papers")
    assert answer.code == 0
    for name in PAPERS:
        assert re.search(rf"^{name} .* 100 %$", answer.out, re.MULTILINE)


@pytest.mark.parametrize("width", ["40", "60", "79"])
def test_no_count_is_cut_where_there_is_little_room(kinlab, monkeypatch, width):
    summary = kinlab("papers", "--json").json["summary"]
    monkeypatch.setenv("COLUMNS", width)
    shown = kinlab("papers").out
    assert "…" not in shown
    assert re.search(r"✓ +≈ +✗ +· +scan +checked$", shown, re.MULTILINE)
    counts = [" +".join(str(summary[name][verdict]) for verdict in VERDICTS) for name in PAPERS]
    assert all(re.search(rf" {line} ", shown) for line in counts)


def test_the_docs_show_what_is_counted(kinlab):
    """Where a total changes, docs/papers.md changes with it."""
    told = (Path(__file__).parents[2] / "docs" / "papers.md").read_text(encoding="utf-8")
    rows = [line for line in kinlab("papers").out.splitlines() if line.endswith(" %")]
    assert len(rows) == len(PAPERS)
    told_rows = [line.split() for line in told.splitlines()]
    assert all(row.split() in told_rows for row in rows)


def test_a_paper_is_shown_with_its_reasoning(kinlab):
    shown = kinlab("papers", "xl430").out
    assert "✗ Table 4 test 9 y\n" in shown
    assert "|15 - 20| = 5" in shown
    assert "Table 2, 27 figures: a target, chosen by the authors" in shown
    assert "most likely the scan's doing" in shown


def test_what_is_measured_stands_in_a_line_for_each_reason(kinlab):
    lines = [line for line in kinlab("papers", "krsri").out.splitlines() if line.startswith("·")]
    assert lines[:2] == [
        "· Table 2, 22 figures: chosen by the authors",
        "· Table 2, 22 figures: measured, the mean of three runs",
    ]
    assert len(lines) == 4 * 2


def test_a_table_is_shown_cell_by_cell(kinlab):
    shown = kinlab("papers", "xl430", "--table", 4).out
    (row,) = re.findall(r"^test 8 .*$", shown, re.MULTILINE)
    assert row.split() == ["test", "8", "2", "✓", "2", "→", "3", "✗", "1", "✓"]
    assert "Table 5" not in shown


@pytest.mark.parametrize("width", ["60", "80", "200"])
def test_a_wide_table_comes_in_parts_that_fit(kinlab, monkeypatch, width):
    monkeypatch.setenv("COLUMNS", width)
    shown = kinlab("papers", "udiebot", "--table", 6).out
    grid = shown[: shown.index("· Table 6,")]
    assert "…" not in grid
    assert all(len(line) <= int(width) for line in grid.splitlines())
    assert grid.count("row 10") >= 1
    assert "-17.095 → -17.10273 ≈" in grid


def test_one_verdict(kinlab):
    answer = kinlab("papers", "--only", "contr", "--json")
    assert {finding["verdict"] for finding in answer.json["findings"]} == {"contradicted"}
    shown = kinlab("papers", "--only", "contradicted").out
    assert "✓" not in shown
    assert all(name in shown for name in PAPERS if any(f["paper"] == name for f in answer.json["findings"]))
    nothing = kinlab("papers", "krsri", "--table", 2, "--only", "contradicted")
    assert (nothing.code, "no finding of it is contradicted" in nothing.out) == (0, True)


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("udi", "--table", "44"), "no table of udiebot-quadruped is named '44'; did you mean 4?"),
        (("--table", "4"), "--table is a table of one paper"),
        (("krsri-hexpod",), "no paper is named 'krsri-hexpod'; did you mean krsri-hexapod"),
        (("--only", "false"), "no verdict is named 'false'"),
        (("--html", "a.html", "--json"), "--html writes whole papers"),
        (("--html", "a.html", "--only", "measured"), "--html writes whole papers"),
    ],
)
def test_wrong_usage_is_said(kinlab, args, said):
    answer = kinlab("papers", *args)
    assert answer.code == 2
    assert said in answer.err
    assert answer.out == ""


class Page(HTMLParser):
    """Whether tags are closed in order, and what the page would load."""

    VOID = ("meta", "br", "link", "img")

    def __init__(self):
        super().__init__()
        self.open = []
        self.loads = []
        self.text = []

    def handle_starttag(self, tag, attrs):
        if tag not in self.VOID:
            self.open.append(tag)
        self.loads += [
            v for k, v in attrs if k in ("src", "href", "srcset", "data") and not v.startswith("#")
        ]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def test_the_page_is_whole_and_loads_nothing(kinlab, tmp_path):
    file = tmp_path / "papers.html"
    answer = kinlab("papers", "--html", file)
    assert (answer.code, answer.out) == (0, "")
    source = file.read_text(encoding="utf-8")
    page = Page()
    page.feed(source)
    page.close()
    assert page.open == []
    assert page.loads == []
    assert "<script" not in source
    assert "@import" not in source
    assert "url(" not in source
    text = "".join(page.text)
    for name in PAPERS:
        assert name in text
    assert "printed 12.38 cm, recomputed 3.08 cm" in text
    assert ">none<" in source  # Table 4's share of nothing, without a unit
    assert list(tmp_path.iterdir()) == [file]


def test_a_page_of_one_paper(kinlab, tmp_path):
    file = tmp_path / "one.html"
    assert kinlab("papers", "krsri", "--html", file).code == 0
    source = file.read_text(encoding="utf-8")
    assert "krsri-hexapod, recomputed" in source
    assert "xl430" not in source
    # What a cause explains in the text lies open, as it does of equations and tables.
    before = source[: source.index("linear in the sense of steady")]
    assert before.count("<details>") == before.count("</details>")


def test_the_page_escapes_what_it_shows(kinlab, tmp_path, monkeypatch):
    def hostile():
        yield xl430_hexapod.JUDGE.claim(
            "<script>alert(1)</script>", "a < b & c", '"<i>', False, "<b>1</b>", "</li>"
        )

    monkeypatch.setattr(xl430_hexapod, "PAPER", replace(xl430_hexapod.PAPER, recompute=hostile))
    file = tmp_path / "hostile.html"
    assert kinlab("papers", "xl430", "--html", file).code == 0
    source = file.read_text(encoding="utf-8")
    assert "<script" not in source
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in source
    assert "a &lt; b &amp; c" in source
    page = Page()
    page.feed(source)
    assert page.open == []


def test_a_page_that_cannot_be_written_is_refused_before_the_work(kinlab, tmp_path):
    answer = kinlab("papers", "--html", tmp_path / "nowhere" / "a.html")
    assert answer.code == 2
    assert "cannot be written: there is no folder" in answer.err
