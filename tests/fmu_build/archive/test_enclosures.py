"""What lies beside the binaries: complete, true to the model, in need of nothing from outside."""

import hashlib
import json
import re
import struct
import xml.etree.ElementTree as ET
import zipfile
import zlib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import fmpy
import numpy as np
import pytest

from fmu_build.archive.description import describe_fmi2
from fmu_build.archive.documentation.document import write_documentation
from fmu_build.archive.documentation.info_pages import read_model_pages
from fmu_build.archive.licences import read_licence
from fmu_build.bundle import build_fmu
from fmu_build.equations.scalars import list_scalars
from fmu_build.roots import ROOTS, Root
from tests.fmu_build.c import native
from tests.fmu_build.modelica import SAMPLED, translated
from tests.modelica.catalogue import read_catalogue_numbers


@pytest.fixture(scope="module", params=[(n, f) for n in ROOTS for f in (2, 3)], ids=str)
def path(request: pytest.FixtureRequest) -> Path:
    name, fmi = request.param
    return build_fmu(name, fmi=fmi)


@pytest.fixture
def archive(path: Path) -> Iterator[zipfile.ZipFile]:
    with zipfile.ZipFile(path) as opened:
        yield opened


def test_noises_are_the_coefficients_of_ieee_952(path: Path) -> None:
    """In the units of the coefficients N, K and B themselves."""
    variables = {v.name: v for v in fmpy.read_model_description(str(path)).modelVariables}
    units = {n.removeprefix("noise."): v.unit for n, v in variables.items() if "noise." in n}
    settable = {n for n, v in variables.items() if v.causality == "parameter"}
    assert {n: u for n, u in units.items() if f"noise.{n}" in settable} == {
        "angleRandomWalk": "rad/sqrt(s)",
        "rateRandomWalk": "rad/s/sqrt(s)",
        "biasInstability": "rad/s",
        "pickOff": "1/sqrt(Hz)",
        "virtualRotation": "1/sqrt(Hz)",
    }


def test_the_page_needs_nothing_from_outside(archive: zipfile.ZipFile) -> None:
    text = archive.read("documentation/index.html").decode()
    page = ET.fromstring(text.removeprefix("<!DOCTYPE html>"))
    links = [e.get(a) for e in page.iter() for a in ("href", "src") if e.get(a)]
    anchors = {f"#{e.get('id')}" for e in page.iter() if e.get("id")}
    inside = {f"documentation/{link}" for link in links if not link.startswith("#")}
    assert inside <= set(archive.namelist())
    assert {link for link in links if link.startswith("#")} <= anchors
    assert not re.search(r"url\((?!#)|@import|<script", text)


def test_the_page_tells_every_input_output_and_parameter(
    archive: zipfile.ZipFile, path: Path
) -> None:
    text = archive.read("documentation/index.html").decode()
    page = ET.fromstring(text.removeprefix("<!DOCTYPE html>"))
    rows = page.findall(".//div[@class='wide']//tr")
    first = ["".join(row[0].itertext()) for row in rows if row[0].tag == "td"]
    described = fmpy.read_model_description(str(path)).modelVariables
    told = ("input", "output", "parameter")
    expected = [
        v.name.rpartition(".")[2] + "".join(f"[{size}]" for size in v.shape)
        for v in described
        if v.causality in told
    ]
    assert Counter(first) == Counter(expected)


EQUATIONS = {
    "HRG": ("Z' = -i nu Z - Z/tau - (D/2) [[ct, st], [st, -ct]] Z",),
    "HRGCarrier": ("x'' - 2 kappa W y' - kappa W' y + (2/tau) x' + D (x' ct + y' st) + w^2 x",),
    "HRGSlow": (
        "theta' = -k Omega + (D/4) sin 4(theta - theta_tau)",
        "2 theta' = (a Re h_n - q Im h_a)/(a^2 - q^2)",
        "Z = exp(i phi) (a [cos alpha; sin alpha] - i q [-sin alpha; cos alpha])",
    ),
}
METHODS = {
    "HRG": "classical Runge-Kutta method of fourth order from sample to sample, in steps of 1 ms",
    "HRGCarrier": "Dormand and Prince of eighth order, at fixed steps from sample to sample, "
    "in steps of 0.005 ms",
    "HRGSlow": "midpoint method of second order from sample to sample, in steps of "
    "samplePeriod (default 100 ms)",
}


def read_page(archive: zipfile.ZipFile) -> str:
    """What a reader sees."""
    text = archive.read("documentation/index.html").decode()
    return "".join(ET.fromstring(text.removeprefix("<!DOCTYPE html>")).itertext())


def test_the_page_has_the_model_s_equations_and_their_sources(
    archive: zipfile.ZipFile, path: Path
) -> None:
    text = read_page(archive)
    for equation in EQUATIONS[path.stem]:
        assert equation in text
    for told in ("Xu et al. (2024)", "D. D. Lynch", "Bryan factor: d theta/dt = -k Omega"):
        assert told in text


def test_the_page_has_the_catalogue_of_mechanisms(archive: zipfile.ZipFile) -> None:
    text = archive.read("documentation/index.html").decode()
    page = ET.fromstring(text.removeprefix("<!DOCTYPE html>"))
    first = {"".join(row[0].itertext()) for row in page.iter("tr")}
    assert {str(number) for number in read_catalogue_numbers()} <= first


def test_the_page_names_the_integrator_and_its_step(archive: zipfile.ZipFile, path: Path) -> None:
    text = read_page(archive)
    assert METHODS[path.stem] in text
    assert not any(METHODS[name] in text for name in ROOTS if name != path.stem)


@pytest.mark.parametrize("root", ROOTS)
def test_every_class_and_function_of_a_model_has_its_page(root: str) -> None:
    dae = native.flat(root)
    pages = read_model_pages(dae)
    for file in {variable.file for variable in dae.variables}:
        assert f".{Path(file).stem}</code></p>" in pages
    for function in dae.functions:
        assert f".{function.name.split('.')[-1]}</code></p>" in pages


def test_an_info_text_that_is_no_html_is_refused(tmp_path: Path) -> None:
    body = SAMPLED.replace("  end M;", '  annotation(Documentation(info="<p>open"));\n  end M;')
    root = Root("M", "P.M", "title", "midpoint", "0.01")
    with pytest.raises(ValueError, match=r"info text of .* is no HTML"):
        write_documentation(translated(tmp_path, body), root, "1")


def test_every_input_and_output_has_a_nominal_value(path: Path) -> None:
    for variable in fmpy.read_model_description(str(path)).modelVariables:
        nominal = variable.nominal or getattr(variable.declaredType, "nominal", None)
        if variable.causality in ("input", "output") and variable.type not in (
            "Integer",
            "Boolean",
        ):
            assert nominal is not None, variable.name


def test_every_input_and_output_is_in_one_terminal(archive: zipfile.ZipFile, path: Path) -> None:
    root = ET.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
    members = Counter(e.get("variableName") for e in root.iter("TerminalMemberVariable"))
    described = fmpy.read_model_description(str(path)).modelVariables
    assert members == Counter(v.name for v in described if v.causality in ("input", "output"))


def test_the_icon_is_a_square_png(archive: zipfile.ZipFile) -> None:
    data = archive.read("terminalsAndIcons/icon.png")
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", data[16:24])
    assert width == height
    start = data.index(b"IDAT") + 4
    (length,) = struct.unpack(">I", data[start - 8 : start - 4])
    assert len(zlib.decompress(data[start : start + length])) == height * (3 * width + 1)


def test_the_bill_holds_the_digest_of_all_that_runs(archive: zipfile.ZipFile) -> None:
    bill = json.loads(archive.read("extra/org.cyclonedx/bom.json"))
    assert (bill["bomFormat"], bill["specVersion"]) == ("CycloneDX", "1.5")
    files = {
        c["name"]: c["hashes"][0]["content"] for c in bill["components"] if c["type"] == "file"
    }
    listed = {
        n for n in archive.namelist() if n.startswith(("binaries/", "sources/", "modelDescription"))
    }
    expected = {n: hashlib.sha256(archive.read(n)).hexdigest() for n in listed}
    assert expected == files
    assert {t["name"] for t in bill["metadata"]["tools"]["components"]} >= {"rumoca", "ziglang"}


def test_reference_results_are_what_an_importer_gets(
    archive: zipfile.ZipFile, path: Path, tmp_path: Path
) -> None:
    """To the last bit, in every step."""
    folder = "extra/org.fmi-standard.fmi-ls-ref"
    manifest = ET.fromstring(archive.read(f"{folder}/fmi-ls-manifest.xml"))
    files = {
        e.get("role"): archive.extract(f"{folder}/{e.get('source')}", tmp_path) for e in manifest
    }
    inputs, expected = (
        np.genfromtxt(files[role], delimiter=",", names=True) for role in ("input", "result")
    )
    result = fmpy.simulate_fmu(
        str(path),
        stop_time=inputs["time"][-1],
        output_interval=inputs["time"][1],
        input=inputs,
        output=list(expected.dtype.names[1:]),
    )
    assert np.ptp(expected["gyroAngle"]) > 1
    for name in expected.dtype.names:
        np.testing.assert_array_equal(result[name], expected[name], err_msg=name)


def test_every_notice_that_is_named_is_there(archive: zipfile.ZipFile) -> None:
    folder = "documentation/licenses/"
    named = re.findall(r"^  (\S+)$", archive.read(f"{folder}license.txt").decode(), re.MULTILINE)
    names = {n.removeprefix(folder) for n in archive.namelist() if n.startswith(folder)}
    assert {*named, "license.txt"} == names
    assert "Redistribution and use" in archive.read(f"{folder}fmi_headers.txt").decode()


def test_the_licence_is_stated_wherever_it_is_looked_for(archive: zipfile.ZipFile) -> None:
    licence = read_licence()
    entry = archive.read("documentation/licenses/license.txt").decode()
    assert entry.startswith("SPDX-License-Identifier: BSD-3-Clause\n\n" + licence.text)
    described = ET.fromstring(archive.read("modelDescription.xml"))
    assert described.get("license") == "BSD-3-Clause"
    assert described.get("author") == "The HRG authors"
    assert described.get("copyright") == licence.copyright
    component = json.loads(archive.read("extra/org.cyclonedx/bom.json"))["metadata"]["component"]
    assert component["licenses"] == [{"expression": "BSD-3-Clause"}]
    assert component["copyright"] == licence.copyright


def test_a_rate_is_shown_in_degrees_an_hour_and_a_circular_frequency_in_hertz(path: Path) -> None:
    described = fmpy.read_model_description(str(path))
    shown = {v.name: v.declaredType.displayUnit for v in described.modelVariables if v.declaredType}
    assert shown["angularRate"] == "deg/h"
    assert shown["frequencyOffset"] == "Hz"
    assert shown["caseTemperature"] == "degC"
    assert shown["gyroAngle"] == "deg"


def test_a_unit_given_by_hand_is_not_the_type_s(tmp_path: Path) -> None:
    body = SAMPLED.replace("parameter Real a = 2", 'parameter A a(unit = "m") = 2').replace(
        "  model M", '  type A = Real(unit = "rad", displayUnit = "deg") "Angle";\n  model M'
    )
    by_name = {s.name: s for s in list_scalars(translated(tmp_path, body))}
    assert by_name["a"].declared is None
    assert by_name["a"].attributes["unit"] == "m"


def test_unknown_units_are_refused(tmp_path: Path) -> None:
    body = SAMPLED.replace('Real a = 2 "a"', 'Real a(unit = "furlong") = 2 "a"')
    with pytest.raises(ValueError, match="unit furlong is not among"):
        describe_fmi2(translated(tmp_path, body), ROOTS["HRG"], "", [])
