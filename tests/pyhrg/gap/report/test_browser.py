"""The page in headless Chromium: picked from, without scripts, printed, narrow and wide."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.report.figures.panels import compute_panels
from pyhrg.gap.report.figures.views import VIEWS
from pyhrg.gap.report.page import build_page
from tests.elements import check_scheme, check_width, open_quiet_page

pytestmark = pytest.mark.needs("chromium")


@pytest.fixture(scope="module")
def address(with_gap: CampaignDiagnosis, tmp_path_factory: pytest.TempPathFactory) -> str:
    file: Path = tmp_path_factory.mktemp("report") / "report.html"
    file.write_text(build_page(with_gap), encoding="utf-8")
    return file.as_uri()


@pytest.fixture
def page(browser: Any, address: str) -> Iterator[Any]:
    yield from open_quiet_page(browser, address)


def visible(page: Any) -> list[dict[str, str]]:
    figures = page.locator("#residuals figure:visible")
    return list(figures.evaluate_all("all => all.map(f => ({...f.dataset}))"))


def test_the_page_opens_on_the_channel_with_most_of_the_gap(page: Any) -> None:
    shown = visible(page)
    assert shown
    assert {f["test"] for f in shown} == {"all"}
    assert {f["view"] for f in shown} == {page.locator("select[name=view]").input_value()}


def test_every_choice_shows_its_panels(page: Any, with_gap: CampaignDiagnosis) -> None:
    made = compute_panels(with_gap).panels
    for view in VIEWS:
        page.locator("select[name=view]").select_option(view.key)
        for test in ("all", *(t.test.id for t in with_gap.tests)):
            page.locator("select[name=test]").select_option(test)
            wanted = [p.axis.key for p in made if p.view == view and p.test == test]
            assert [f["axis"] for f in visible(page)] == wanted


def test_a_coordinate_alone_is_large(page: Any) -> None:
    page.locator("select[name=axis]").select_option("wave_angle")
    assert len(visible(page)) == 1
    assert page.locator("#residuals svg:visible").bounding_box()["width"] > 600


def test_a_test_that_stands_still_says_so(page: Any) -> None:
    assert not page.locator("#none").is_visible()
    page.locator("select[name=test]").select_option("still")
    page.locator("select[name=axis]").select_option("rate")
    assert visible(page) == []
    assert page.locator("#none").is_visible()


def test_without_scripts_all_channels_are_there(browser: Any, address: str) -> None:
    context = browser.new_context(java_script_enabled=False)
    opened = context.new_page()
    opened.goto(address)
    assert not opened.locator("#filters").is_visible()
    shown = opened.locator("#residuals figure:visible")
    views = set(shown.evaluate_all("all => all.map(f => f.dataset.view)"))
    assert views == {view.key for view in VIEWS}
    assert set(shown.evaluate_all("all => all.map(f => f.dataset.test)")) == {"all"}
    context.close()


@pytest.mark.parametrize("dark", [False, True])
def test_light_and_dark(browser: Any, address: str, dark: bool) -> None:
    check_scheme(browser, address, dark)


@pytest.mark.parametrize("width", [360, 800, 1600])
def test_nothing_reaches_over_the_edge(browser: Any, address: str, width: int) -> None:
    check_width(browser, address, width)
