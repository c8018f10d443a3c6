"""The page in headless Chromium: clicked through, hovered, typed at, without scripts, printed."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from ins_eval.study.report.page import make_sections, select_shown, write_page
from ins_eval.study.study_data import StudyData
from ins_eval.study.summary.predict_error import predict_from_study
from ins_eval.study.tables import columns as c
from tests.elements import check_scheme, check_width, open_quiet_page
from tests.ins_eval.study.report.colours import SMALLEST_DIFFERENCE, measure_difference
from tests.ins_eval.study.report.synthetic import MISSIONS, synthetic

pytestmark = pytest.mark.needs("chromium")


@pytest.fixture(scope="module")
def result() -> StudyData:
    return synthetic(20)


@pytest.fixture(scope="module")
def shown(result: StudyData) -> pd.DataFrame:
    """The rows of the page, in nmi."""
    return select_shown(result).table


@pytest.fixture(scope="module")
def address(result: StudyData, tmp_path_factory: pytest.TempPathFactory) -> str:
    folder: Path = tmp_path_factory.mktemp("report")
    write_page(result, folder)
    return (folder / "report.html").as_uri()


@pytest.fixture
def page(browser: Any, address: str) -> Iterator[Any]:
    yield from open_quiet_page(browser, address)


def chosen(table: pd.DataFrame, **wanted: str) -> pd.DataFrame:
    for column, value in wanted.items():
        table = table[table[column] == value]
    return table


def test_the_page_opens_on_the_mean_calibration(page: Any, shown: pd.DataFrame) -> None:
    rows = chosen(shown, calibration="mean")
    assert page.locator("h1").is_visible()
    live = page.locator("[data-panel=fitted_map] .live").inner_text()
    assert live.startswith(f"{len(rows)} flights; R² ")
    shown = page.locator("[data-panel=fitted_map] .dots:visible").count()
    assert shown == rows[c.CLASS].nunique()


def test_every_choice_can_be_made(page: Any, shown: pd.DataFrame) -> None:
    for name in ("calibration", "class", "predictor"):
        select = page.locator(f"#filters select[name={name}]")
        for value in select.locator("option").evaluate_all("all => all.map(o => o.value)"):
            select.select_option(value)
        select.select_option("all")
    live = page.locator("[data-panel=true_parameters] .live").inner_text()
    assert live.startswith(f"{len(shown)} flights")


def test_a_class_alone(page: Any, shown: pd.DataFrame) -> None:
    page.locator("select[name=class]").select_option("car")
    rows = chosen(shown, calibration="mean", mission_class="car")
    for predictor in c.PREDICTORS:
        live = page.locator(f"[data-panel={predictor.key}] .live").inner_text()
        assert live.startswith(f"{len(rows)} flights")
    assert page.locator("[data-class=ship]:visible").count() == 0
    assert page.locator("tr[data-class=car]:visible").count() > 0


def test_a_predictor_alone(page: Any) -> None:
    page.locator("select[name=predictor]").select_option("fitted_map")
    visible = page.locator("#predictions figure:visible")
    assert visible.evaluate_all("all => all.map(f => f.dataset.panel)") == ["fitted_map"]
    assert visible.locator("svg").bounding_box()["width"] > 600


def test_hovering_a_dot_tells_its_flight(page: Any, shown: pd.DataFrame) -> None:
    page.locator("select[name=predictor]").select_option("fitted_map")
    rows = chosen(shown, calibration="mean")
    row = rows.loc[rows[c.FLOWN_RADIAL].idxmax()]
    svg = page.locator("[data-panel=fitted_map] svg")
    svg.scroll_into_view_if_needed()
    place = svg.evaluate(
        """(svg, [x, y]) => {
          const [low, high] = svg.dataset.range.split(" ").map(Number).map(Math.log10);
          const [left, right, bottom, top] = svg.dataset.plot.split(" ").map(Number);
          const share = (v) => (Math.log10(v) - low) / (high - low);
          const at = new DOMPoint(left + share(x) * (right - left),
            bottom + share(y) * (top - bottom)).matrixTransform(svg.getScreenCTM());
          return [at.x, at.y];
        }""",
        [row["fitted_map_median_m"], row[c.FLOWN_RADIAL]],
    )
    page.mouse.move(*place)
    tip = page.locator("#tip").inner_text()
    assert f"Triad {row[c.TRIAD]}, {row[c.MISSION]} ({row[c.CLASS]})" in tip
    assert "mean calibrated, co-simulated" in tip
    assert f"flown {float(f'{row[c.FLOWN_RADIAL]:.3g}'):,g} nmi (" in tip
    assert svg.locator(".mark").get_attribute("visibility") == "visible"
    page.mouse.move(2, 2)
    assert not page.locator("#tip").is_visible()


def test_dots_can_be_stepped_through_with_the_keyboard(page: Any, shown: pd.DataFrame) -> None:
    rows = chosen(shown, calibration="mean")
    order = rows.sort_values(c.FLOWN_RADIAL)[c.TRIAD].tolist()
    page.locator("[data-panel=true_parameters] svg").focus()
    for triad in (order[0], order[1]):
        page.keyboard.press("ArrowRight")
        assert page.locator("#tip").inner_text().startswith(f"Triad {triad},")
    page.keyboard.press("ArrowLeft")
    assert page.locator("#tip").inner_text().startswith(f"Triad {order[0]},")
    page.keyboard.press("Escape")
    assert not page.locator("#tip").is_visible()


def test_links_and_folds_open(page: Any, result: StudyData) -> None:
    for section in make_sections(select_shown(result)):
        page.locator(f'nav a[href="#{section.name}"]').click()
        assert page.locator(f"#{section.name} h2").is_visible()
    for fold in page.locator("details:visible").all():
        fold.locator("summary").click()
        assert fold.get_attribute("open") is not None


def test_without_scripts_every_figure_and_table_is_there(
    browser: Any, address: str, shown: pd.DataFrame
) -> None:
    context = browser.new_context(java_script_enabled=False)
    opened = context.new_page()
    opened.goto(address)
    assert not opened.locator("#filters").is_visible()
    assert opened.locator("#predictions svg:visible").count() == len(c.PREDICTORS)
    groups = shown.groupby([c.CALIBRATION, c.CLASS]).ngroups
    assert opened.locator("[data-panel=true_parameters] .dots").count() == groups
    assert opened.locator("#coverage table:visible").count() > 1
    context.close()


@pytest.mark.parametrize("dark", [False, True])
def test_light_and_dark(browser: Any, address: str, dark: bool) -> None:
    check_scheme(browser, address, dark)


def test_an_empty_selection_explains_itself(
    browser: Any, result: StudyData, tmp_path: Path
) -> None:
    table = result.table
    without = (table[c.CLASS] == "ship") & (table[c.CALIBRATION] == "mean")
    scores = [s for s in result.scores if (s.mission_class, s.calibration) != ("ship", "mean")]
    write_page(replace(result, table=table[~without], scores=scores), tmp_path)
    opened = browser.new_page()
    opened.goto((tmp_path / "report.html").as_uri())
    assert not opened.locator("#empty").is_visible()
    opened.locator("#filters select[name=class]").select_option("ship")
    assert "No judged flight of this study is of this selection (ship, mean" in (
        opened.locator("#empty").inner_text()
    )
    assert opened.locator("#budget .none").inner_text() == "Nothing here is of the selection above."
    opened.locator("#filters select[name=calibration]").select_option("map")
    assert not opened.locator("#empty").is_visible()
    assert opened.locator("#budget .none").count() == 0
    opened.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_colours_of_a_legend_are_distinct(browser: Any, address: str, scheme: str) -> None:
    """Of mission classes, parts of the error and lines of the lead case, in both schemes."""
    opened = browser.new_page(color_scheme=scheme)
    opened.goto(address)
    legends = opened.evaluate(
        """() => [...document.querySelectorAll(".legend, .lead-case svg, .shares")].map(
          (legend) => [...legend.querySelectorAll("li svg, g.lead, rect")].map(
            (entry) => getComputedStyle(entry).color))"""
    )
    opened.close()
    sizes = {len(colours) for colours in legends}
    assert sizes == {3, len(set(MISSIONS.values())), len(c.PARTS)}
    for colours in legends:
        for one, other in combinations(colours, 2):
            assert measure_difference(one, other) > SMALLEST_DIFFERENCE, (one, other)


def test_own_gyro_is_predicted_as_in_the_terminal(page: Any, result: StudyData) -> None:
    form, output = page.locator("#own-gyro"), page.locator("#own-error")
    assert output.locator("p").count() == 2
    form.locator("select[name=mission]").select_option("ship")
    form.locator("select[name=calibration]").select_option("map")
    for fixed, circumference in ((0.0123, 0.31), (0.004, 7e-5), (3.3, 0.011)):
        form.locator("input[name=fixed_deg_h]").fill(f"{fixed:g}")
        form.locator("input[name=circumference_deg_h]").fill(f"{circumference:g}")
        given = {"fixed_deg_h": fixed, "circumference_deg_h": circumference}
        expected = predict_from_study(result, "ship", given, "map")
        assert output.locator("p").all_inner_texts() == [str(each) for each in expected]
    form.locator("input[name=fixed_deg_h]").fill("much")
    assert output.locator("p").first.inner_text() == (
        "fixed position: found much, expected a number from 0.000001 to 100 deg/h"
    )
    for name in ("fixed_deg_h", "circumference_deg_h"):
        form.locator(f"input[name={name}]").fill("")
    assert output.inner_text() == "Type a bench figure."


def test_claims_fit_a_phone_and_wide_tables_say_that_they_scroll(
    browser: Any, address: str
) -> None:
    opened = browser.new_page(viewport={"width": 390, "height": 800})
    opened.goto(address)
    claims = opened.locator("header .wide")
    assert claims.evaluate("box => box.scrollWidth <= box.clientWidth")
    assert not claims.evaluate("box => box.classList.contains('over')")
    for box in opened.locator("main .wide:visible").all():
        scrolls = box.evaluate("box => box.scrollWidth > box.clientWidth + 1")
        cue = box.evaluate("box => getComputedStyle(box, '::before').content")
        assert (cue != "none") == scrolls
    assert opened.locator("main .wide.over:visible").count() > 0
    opened.close()


@pytest.mark.parametrize("width", [360, 390, 800, 1600])
def test_nothing_reaches_over_the_edge(browser: Any, address: str, width: int) -> None:
    check_width(browser, address, width)
