"""Plans in money: cents as printed add up, in every language; texts are told as texts."""

from __future__ import annotations

import csv
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest
from hostile_names import HOSTILE
from matplotlib.patches import Rectangle
from money_plans import in_money
from plan_kinds import plan_kind

from platoon_osm.costs.cost_figure import CostFigure
from platoon_osm.costs.money.objective import money_costs
from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.gain import GainSharing
from platoon_osm.plans.plan import JointPlan, Plan
from platoon_osm.plans.trip import Trip
from platoon_osm.report.charts.bill_figure import bill_figure
from platoon_osm.report.document.document import document_of, report_document
from platoon_osm.report.document.findings import find
from platoon_osm.report.exporters import EXPORTERS
from platoon_osm.report.language.speech import speaking
from platoon_osm.report.markup.fragments import NOTHING, Tree, written
from platoon_osm.report.markup.quantities import carbon, cost_unit, litres
from platoon_osm.report.pages.money_tables import money_tables
from platoon_osm.report.pages.page_data import page_data
from platoon_osm.report.pages.panel import page_body
from platoon_osm.report.sheets.steps import steps_of
from platoon_osm.report.sheets.write import write_sheets
from platoon_osm.shown_text import fitted

SIGNS = {"en": (",", "."), "de": (".", ","), "it": (".", ",")}


class Tables(HTMLParser):
    """The texts of all cells of all tables, as a reader sees them."""

    def __init__(self) -> None:
        super().__init__()
        self.tables: list[list[list[str]]] = []
        self.inside = False

    def handle_starttag(self, tag: str, attrs: object) -> None:
        del attrs
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self.tables[-1][-1].append("")
            self.inside = True

    def handle_endtag(self, tag: str) -> None:
        self.inside = self.inside and tag not in ("td", "th")

    def handle_data(self, data: str) -> None:
        if self.inside:
            self.tables[-1][-1][-1] += data


def tables_of(tree: Tree) -> list[list[list[str]]]:
    parser = Tables()
    parser.feed(written(tree))
    return parser.tables


def cents(text: str, language: str = "en") -> int:
    """What a reader takes a printed amount for; it has two decimals."""
    thousands, decimal = SIGNS[language]
    text = text.replace("\u2212", "-").replace(thousands, "")
    assert re.fullmatch(rf"[+-]?\d+\{decimal}\d\d", text), text
    return int(text.replace(decimal, ""))


@pytest.mark.parametrize(
    ("language", "most_cents"), [("en", 90_000), ("de", 9_000_000), ("it", 90_000)]
)
def test_cents_add_up_as_they_are_printed(
    plan: JointPlan, net: RoadNetwork, language: str, most_cents: int
) -> None:
    for seed in range(2):
        document = document_of(in_money(plan, seed, "EUR", most_cents), net, language=language)
        with speaking(language):
            costs, bill, _, _, gain = tables_of(page_body(document, NOTHING))[:5]
        # What each pays alone, as planned, and what it saves: rows, then all vehicles.
        main = [[cents(cell.split()[0], language) for cell in row[1:]] for row in costs[1:]]
        for alone, joint, saved in main:
            assert alone - joint == saved
        assert [sum(column) for column in zip(*main[:-1], strict=True)] == main[-1]
        # For each term and in all, as planned and alone.
        paid = [
            [[cents(one, language) for one in cell.split()] for cell in row[1:]] for row in bill[1:]
        ]
        for row in paid:
            for planned in (0, 1):
                assert sum(cell[planned] for cell in row[:-1]) == row[-1][planned]
        for term in range(len(paid[0])):
            for planned in (0, 1):
                column = [row[term][planned] for row in paid]
                assert sum(column[:-1]) == column[-1]
        assert [(row[-1][1], row[-1][0]) for row in paid] == [(a, j) for a, j, _ in main]
        # What is saved, what is paid for it and what each has.
        shares = [[cents(cell, language) for cell in row[1:]] for row in gain[1:]]
        for saves, receives, has in shares:
            assert saves + receives == has
        assert shares[-1][1] == 0
        assert [sum(column) for column in zip(*shares[:-1], strict=True)] == shares[-1]
        assert [row[0] for row in shares] == [row[2] for row in main]
        # Gain in company less longer way and waiting is what is saved.
        for vehicle in document.vehicles:
            gained, lost = cents(vehicle.text.gain, language), cents(vehicle.text.detour, language)
            assert gained - lost == cents(vehicle.text.saved, language)


def test_groups_add_up_too(two: JointPlan, net: RoadNetwork) -> None:
    document = document_of(in_money(two), net)
    sums = [[cents(t) for t in (g.text.alone, g.text.joint, g.text.saved)] for g in document.groups]
    whole = document.totals.text
    assert [sum(column) for column in zip(*sums, strict=True)] == [
        cents(text) for text in (whole.alone, whole.joint, whole.saved)
    ]


def test_terms_that_cost_nothing_have_no_column(plan: JointPlan, net: RoadNetwork) -> None:
    document = document_of(in_money(plan), net)
    text = written(money_tables(document))
    head = tables_of(money_tables(document))[0][0]
    assert head[1:] == ["Fuel", "Driver", "Toll", "Waiting", "In all"]
    assert "Not paid for: CO2, Delay." in text


def test_the_head_tells_money_fuel_and_carbon(plan: JointPlan, net: RoadNetwork) -> None:
    told = in_money(plan)
    assert told.bill is not None
    one, two, three = document_of(told, net).totals.figures
    assert one.figure == cost_unit("EUR", to_the_cent=True).full(told.bill.saved_cents / 100)
    assert "to be expected with delays" in one.label
    assert two.figure == f"{told.bill.saved_fuel_l:.1f}\u00a0l"
    assert three.figure == carbon(told.bill.saved_kg[1])
    assert carbon(told.bill.saved_kg[0]) in three.label


def test_what_is_rounded_away_has_no_sign() -> None:
    assert litres(-1e-13) == "0.0\u00a0l"
    assert carbon(-0.04) == "0.0\u00a0kg"
    assert carbon(-0.06) == "-0.1\u00a0kg"


def test_a_merge_says_how_likely_it_is(plan: JointPlan, net: RoadNetwork) -> None:
    merges = [e for e in document_of(in_money(plan), net).events if e.kind == "merge"]
    assert merges
    for event in merges:
        assert event.text.endswith("78\u202f% likely")
        assert "up to 12 min" in event.detail
        assert "\u20ac9.00 dearer if missed" in event.detail


@pytest.mark.parametrize(
    ("language", "currency", "text"),
    [
        ("en", "EUR", "\u20ac1,234.50"), ("en", "USD", "$1,234.50"),
        ("en-US", "USD", "$1,234.50"), ("de", "EUR", "1.234,50\u00a0\u20ac"),
        ("de", "USD", "1.234,50\u00a0$"), ("it", "EUR", "1.234,50\u00a0\u20ac"),
    ],
)  # fmt: skip
def test_money_is_written_as_the_language_does(language: str, currency: str, text: str) -> None:
    with speaking(language):
        assert cost_unit(currency, 5000.0).full(1234.5) == text
        assert cost_unit(currency, 1e9, to_the_cent=True).full(1234.5) == text


@pytest.mark.parametrize(
    ("worst", "coalitions", "words"),
    [
        (-3.0, 15, "none of 15 groups could do better by itself"),
        (-3.0, 0, "no group could do better by itself"),
        (0.4, 15, "by a whole cent"),
        (250.0, 15, "a group could gain \u20ac2.50 more"),
        (None, 0, "Nobody is worse off."),
    ],
)
def test_the_proof_says_what_was_found(
    plan: JointPlan, net: RoadNetwork, worst: float | None, coalitions: int, words: str
) -> None:
    told = in_money(plan)
    assert told.gain is not None
    fair = tuple(replace(one, saved_cents=5, share_cents=5) for one in told.gain.vehicles)
    gain = replace(told.gain, vehicles=fair, worst_cents=worst, coalitions=coalitions)
    text = written(money_tables(document_of(replace(told, gain=gain), net)))
    assert words in text
    assert ('class="proof good"' in text) == (worst is None or worst < 1)


def test_who_is_worse_off_is_named(plan: JointPlan, net: RoadNetwork) -> None:
    told = in_money(plan)
    assert told.gain is not None
    first, second, *rest = told.gain.vehicles
    moved = first.share_cents + 5
    poor = replace(first, share_cents=-5), replace(second, share_cents=second.share_cents + moved)
    gain: GainSharing = replace(told.gain, vehicles=(*poor, *rest))
    text = written(money_tables(document_of(replace(told, gain=gain), net)))
    assert "A would be better off alone" in text
    assert 'class="proof plain"' in text


def test_a_plan_without_a_bill_says_nothing_of_it(plan: JointPlan, net: RoadNetwork) -> None:
    document = document_of(plan, net)
    assert money_tables(document) == ()
    assert not {"bill", "gain", "chances"} & report_document(plan, net).keys()


def test_the_document_has_bill_gain_and_chances(plan: JointPlan, net: RoadNetwork) -> None:
    told = in_money(plan)
    data = report_document(told, net)
    assert told.bill is not None
    assert told.gain is not None
    assert [one["joint_cents"] for one in data["bill"]["vehicles"]] == [
        list(one.joint_cents) for one in told.bill.vehicles
    ]
    assert [one["share_cents"] for one in data["gain"]["vehicles"]] == [
        one.share_cents for one in told.gain.vehicles
    ]
    for one in data["chances"]["meetings"]:
        assert data["events"][one["event"]]["kind"] == "merge"
    # The page has them as tables; its script needs none of them.
    assert "joint_cents" not in page_data(document_of(told, net), None)


def tags_of(text: str) -> list[str]:
    return re.findall(r"</?[a-z][a-z0-9]*(?: [a-z-]+(?==))?", text)


def test_hostile_texts_of_a_bill_stay_texts(plan: JointPlan, net: RoadNetwork) -> None:
    def page(texts: list[str]) -> tuple[str, Plan]:
        told = in_money(plan)
        assert told.bill is not None
        assert told.gain is not None
        figures = tuple(CostFigure(one, 1.0, one, one) for one in texts)
        terms = (*told.bill.terms[:-1], texts[0])
        gain = replace(told.gain, rule=texts[1], manner=texts[2], remark=texts[3])
        told = replace(told, bill=replace(told.bill, figures=figures, terms=terms), gain=gain)
        return written(money_tables(document_of(told, net))), told

    hostile, _ = page(HOSTILE)
    plain, _ = page([f"name {number}" for number in range(len(HOSTILE))])
    assert tags_of(hostile) == tags_of(plain)
    sources = tables_of_text(hostile)[-2]
    blank = str.split
    assert [blank(row[2]) for row in sources[1:]] == [blank(fitted(one)) for one in HOSTILE]


def tables_of_text(text: str) -> list[list[list[str]]]:
    parser = Tables()
    parser.feed(text)
    return parser.tables


def test_tables_of_pandas_add_up(plan: JointPlan) -> None:
    told = in_money(plan)
    assert told.bill is not None
    assert told.gain is not None
    bill = told.to_frame("bill")
    assert list(bill.columns) == ["vehicle", "term", "alone_EUR", "joint_EUR", "saved_EUR"]
    assert round(100 * bill["saved_EUR"].sum()) == told.bill.saved_cents
    assert round(100 * told.to_frame()["cost_EUR"].sum()) == told.bill.joint_cents
    by_term = bill.groupby("term")["joint_EUR"].sum()
    assert round(100 * by_term["waiting"]) == told.bill.of_term("waiting")[1]
    gain = told.to_frame("gain")
    assert round(100 * gain["receives_EUR"].sum()) == 0
    assert (100 * gain["share_EUR"]).round().tolist() == [
        one.share_cents for one in told.gain.vehicles
    ]
    chances = told.to_frame("chances")
    assert set(chances["chance"]) == {0.784}
    assert (chances["wait_up_to_min"] == 12).all()
    assert all(told.events[event].kind == "merge" for event in chances["event"])
    for what in ("bill", "gain", "chances"):
        with pytest.raises(ScenarioError, match=f"the plan has no {what}"):
            plan.to_frame(what)


def test_the_bill_as_a_file(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    told = in_money(plan, text="=1+1")
    assert told.bill is not None
    told = replace(told, trips=(replace(told.trips[0], vehicle="=1+1"), *told.trips[1:]))
    EXPORTERS["bill"].write(told, net, tmp_path / "bill.csv")
    rows = list(csv.DictReader((tmp_path / "bill.csv").read_text("utf-8").splitlines()))
    assert rows[0]["vehicle"] == "'=1+1"
    for kind in ("alone", "joint", "saved"):
        amounts = [round(100 * float(row[kind])) for row in rows if row["unit"] == "EUR"]
        assert sum(amounts) == getattr(told.bill, f"{kind}_cents")
    fuel_l = sum(float(row["saved"]) for row in rows if row["unit"] == "l")
    assert fuel_l == pytest.approx(told.bill.saved_fuel_l, abs=1e-2)
    kg = [float(row["saved"]) for row in rows if row["term"] == "CO2e well to wheel"]
    assert sum(kg) == pytest.approx(told.bill.saved_kg[1], abs=1e-2)
    with pytest.raises(ScenarioError, match="bill: the costs of the plan are no money"):
        EXPORTERS["bill"].write(plan, net, tmp_path / "none.csv")
    assert not (tmp_path / "none.csv").exists()


def test_the_bill_as_a_figure(plan: JointPlan, net: RoadNetwork) -> None:
    told = in_money(plan)
    assert told.bill is not None
    figure = bill_figure(document_of(told, net))
    assert figure is not None
    costs, saved = figure.axes
    # Alone, then as planned, of each vehicle: as long as what it pays.
    for row, own in enumerate(told.bill.vehicles):
        for shift, paid in ((-0.2, own.alone_cents), (0.2, own.joint_cents)):
            bars = [
                bar for bar in costs.patches
                if isinstance(bar, Rectangle)
                and bar.get_y() + bar.get_height() / 2 == pytest.approx(row + shift)
            ]  # fmt: skip
            assert [bar.get_width() for bar in bars] == pytest.approx([one / 100 for one in paid])
    texts = [text.get_text() for text in saved.texts]
    assert [cents(text) for text in texts] == [one.saved_cents for one in told.bill.vehicles]
    assert bill_figure(document_of(plan, net)) is None


def test_a_sheet_says_when_to_give_up() -> None:
    """As soon as waiting is worth no more, but not before the planned moment."""
    plan, net = plan_kind("three vehicles")
    told, seen = in_money(plan), 0
    for index in range(len(plan.trips)):
        free, bound = (
            steps_of(found.plan, found.net, index) for found in (find(plan, net), find(told, net))
        )
        for step, own in zip(free, bound, strict=True):
            if step.without is None or own.without is None:
                continue
            assert step.leaves_s is not None
            assert own.without.until_s is not None
            worth_s = step.leaves_s - step.wait_s + (660.0 if step.moves else 720.0)
            latest = step.without.until_s
            expected = max(min(worth_s, worth_s if latest is None else latest), step.leaves_s)
            assert own.without.until_s == pytest.approx(expected, abs=60)
            seen += own.without.until_s != latest
    assert seen


@pytest.mark.parametrize("language", SIGNS)
def test_a_sheet_says_what_the_trip_saves(
    plan: JointPlan, net: RoadNetwork, language: str, tmp_path: Path
) -> None:
    told = in_money(plan, seed=3)
    assert told.bill is not None
    assert told.gain is not None
    write_sheets(told, net, tmp_path / "sheets.html", language=language)
    lines = re.findall(r'<p class="law"><bdi>(.*?)</bdi>', (tmp_path / "sheets.html").read_text())
    together = [k for k, one in enumerate(plan.vehicles) if one.platoon_m]
    assert len(lines) == len(together)
    with speaking(language):
        unit = cost_unit("EUR", to_the_cent=True)
        for line, index in zip(lines, together, strict=True):
            own, part = told.bill.vehicles[index], told.gain.vehicles[index]
            for amount in (own.saved_cents, part.payment_cents):
                assert unit.full(abs(amount) / 100) in line
            assert unit.full(part.share_cents / 100) in line
            assert carbon(own.alone_kg[1] - own.joint_kg[1]) in line
    write_sheets(plan, net, tmp_path / "plain.html")
    assert 'class="law"' not in (tmp_path / "plain.html").read_text()


def test_remarks_on_shares_are_told_in_the_language(plan: JointPlan, net: RoadNetwork) -> None:
    told = in_money(plan)
    assert told.gain is not None
    remarks = (
        "by the rule alone A would be worse off; these are the nearest shares that leave nobody "
        "worse off",
        "14 linked vehicles are too many for the least core; shared equally",
        "a bound covers all groups of 14 linked vehicles; none was tried one by one",
        "planned apart in groups all would save 1.50 EUR more",
    )
    gain = replace(told.gain, remark="; ".join(remarks))
    german = document_of(replace(told, gain=gain), net, language="de").gain
    assert german is not None
    assert "linked" not in german.remark
    assert "zu viele f\u00fcr den Least Core; gleich geteilt; eine Schranke" in german.remark
    assert german.remark.endswith("w\u00fcrden alle 1,50 EUR mehr sparen")
    nothing = tuple(replace(one, saved_cents=0, share_cents=0) for one in gain.vehicles)
    assert document_of(replace(told, gain=replace(gain, vehicles=nothing)), net).gain is None


def test_events_tell_what_those_who_join_save() -> None:
    net = RoadNetwork.from_edges(
        [0, 1, 2, 4], [1, 2, 3, 1], [50e3, 200e3, 50e3, 40e3],
        lon=[9.0, 9.6, 11.0, 11.6, 9.4], lat=[45.0, 45.0, 45.0, 45.0, 45.3],
    )  # fmt: skip
    trips = [Trip("A", 0, 3), Trip("B", 4, 2)]
    plan = plan_joint(net, money_costs("eu", positions="nacfe"), trips, master="A")
    assert plan.bill is not None
    bill = plan.bill.vehicles[1]
    assert bill.saved_cents > 100
    kg = bill.alone_kg[1] - bill.joint_kg[1]
    (merge,) = [one for one in document_of(plan, net).events if one.kind == "merge"]
    assert f"B saves €{bill.saved_cents / 100:.2f} and {carbon(kg)} of CO2e" in merge.detail
    with speaking("de"):
        (merge,) = [one for one in document_of(plan, net).events if one.kind == "merge"]
        assert "B spart in Gesellschaft" in merge.detail
    other = plan_joint(net, paper_weights(net), trips, master="A")
    assert not [one for one in document_of(other, net).events if "saves" in one.detail]
