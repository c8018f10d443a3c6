"""What breaks each rule: beginning of its statement, version of FMI, change of our FMU, finding."""

from collections.abc import Callable

from tests.fmu_build.check.tampering import Content, added, description, removed, renamed, text

TERMINALS = "terminalsAndIcons/terminalsAndIcons.xml"
BUILD = "sources/buildDescription.xml"
LAST_UNKNOWN = r'(<Unknown index="\d+" dependencies="[\d ]*" />)\s*(</InitialUnknowns>)'

CASES: list[tuple[str, int, Callable[[Content], None], str]] = [
    ("no path occurs twice", 2, added("../outside.txt"), "leads outside"),
    ("no path occurs twice", 3, renamed("^sources/core.c", r"sources\\\\core.c"), "backslash"),
    ("variable names keep", 2, description('"gyroRate"', '"gyro rate"'), "no structured name"),
    ("variable names keep", 3, description('"gyroRate"', '"gyro..rate"'), "'gyro..rate' is no"),
    ("there are sources or binaries", 2, removed("^(sources|binaries)/"), "neither"),
    ("every platform's folder", 2, renamed("/HRG.so", "/Other.so"), "HRG.so is missing"),
    ("every platform's folder", 3, added("binaries/x86_64-windows/a.txt"), "HRG.dll is missing"),
    ("every platform's folder", 3, added("binaries/aarch64-darwin/a.txt"), "HRG.dylib is missing"),
    ("every platform's folder", 2, added("binaries/darwin64/a.txt"), "HRG.dylib is missing"),
    ("a documentation folder", 3, removed("index.html"), "index.html is missing"),
    ("a licenses folder", 3, removed("license.txt"), "has none of"),
    ("folders in extra", 2, renamed("org.cyclonedx", "bill"), "extra/bill"),
    ("the FMU offers an interface", 3, description("CoSimulation", "Simulation"), "neither"),
    (
        "states that are serialized",
        2,
        description('canGetAndSetFMUstate="true"', ""),
        "canSerializeFMUstate without canGetAndSetFMUstate",
    ),
    (
        "states that are serialized",
        3,
        description('canGetAndSetFMUState="true"', 'canGetAndSetFMUState="false"'),
        "canSerializeFMUState without canGetAndSetFMUState",
    ),
    ("the default experiment", 2, description('stepSize="[^"]*"', 'stepSize="0"'), "stepSize is 0"),
    ("the default experiment", 3, description('stopTime="[^"]*"', 'stopTime="0"'), "not after"),
    (
        "a fixed internal step",
        3,
        description('fixedInternalStepSize="[^"]*"', 'fixedInternalStepSize="0"'),
        "fixedInternalStepSize is 0",
    ),
    ("listed source files", 2, removed("sources/core.c"), "SourceFiles lists core.c"),
    ("listed source files", 3, removed("sources/core.c"), "build description lists core.c"),
    (
        "folders that the build",
        3,
        text(BUILD, "</SourceFileSet>", '<IncludeDirectory name="include"/></SourceFileSet>'),
        "includes the folder include",
    ),
    ("the build description builds", 3, text(BUILD, '"HRG"', '"Other"'), "builds Other"),
    ("the build description builds", 3, removed(BUILD), "buildDescription.xml is missing"),
    (
        "the build description is of",
        3,
        text(BUILD, 'fmiVersion="3.0"', 'fmiVersion="2.0"'),
        "is 2.0, expected 3.0",
    ),
    ("every output is listed", 2, description(r"<Unknown [^>]*/>\s*", ""), "is not listed"),
    ("every output is listed", 3, description(r"<Output [^>]*/>\s*", ""), "is not listed"),
    (
        "initial unknowns are listed",
        2,
        description(r"<InitialUnknowns>(.*)" + LAST_UNKNOWN, r"<InitialUnknowns>\2\1\3"),
        "follows index",
    ),
    ("initial unknowns are all", 2, description(LAST_UNKNOWN, r"\2"), "is not listed"),
    ("initial unknowns are all", 3, description(r"<InitialUnknown [^>]*/>", ""), "is not listed"),
    (
        "dependencies name variables",
        3,
        description('dependencies="1"', 'dependencies="99999"'),
        "valueReference 99999, which no variable has",
    ),
    (
        "dependencies name variables",
        2,
        description('dependencies="2"', 'dependencies="2" dependenciesKind="fixed fixed"'),
        "1 dependencies and 2 kinds",
    ),
    (
        "terminals name variables",
        3,
        text(TERMINALS, 'variableName="angularRate"', 'variableName="nowhere"'),
        "names nowhere, which is no variable",
    ),
    (
        "terminals are of known",
        2,
        text(TERMINALS, 'matchingRule="plug"', 'matchingRule="glue"'),
        "matching rule glue",
    ),
    (
        "terminals are of known",
        3,
        text(TERMINALS, 'variableKind="signal"', 'variableKind="noise"'),
        "a member of kind noise",
    ),
    (
        "names of terminals",
        3,
        text(TERMINALS, 'memberName="accelerationX"', 'memberName="angularRate"'),
        "angularRate is there more than once",
    ),
    ("icons that are described", 3, removed("icon.png"), "icon.png is missing"),
    (
        "an SVG picture",
        3,
        renamed("terminalsAndIcons/icon.png", "terminalsAndIcons/icon.svg"),
        "icon.svg has no PNG",
    ),
    (
        "the terminals' version",
        3,
        text(TERMINALS, 'fmiVersion="3.0"', 'fmiVersion="3.1"'),
        "is 3.1, expected 3.0",
    ),
    (
        "base units and their factors",
        2,
        description('<BaseUnit rad="1" s="-1" />', '<BaseUnit rad="1" s="-1" factor="2" />'),
        "rad/s has the factor 2.0, expected 1.0",
    ),
    (
        "base units and their factors",
        3,
        description('<BaseUnit m="1" s="-2" />', '<BaseUnit m="1" s="-1" />'),
        "m/s2 has the base units m1.s-1, expected m1.s-2",
    ),
    (
        "base units and their factors",
        3,
        description('<BaseUnit K="1" />', '<BaseUnit K="1" offset="5" />'),
        "K has the offset 5.0, expected 0.0",
    ),
    (
        "factors and offsets of display",
        2,
        description('name="deg/h" factor="[^"]*"', 'name="deg/h" factor="57.29577951308232"'),
        "deg/h of rad/s has the factor 57.29",
    ),
    (
        "factors and offsets of display",
        3,
        description('name="Hz" factor="[^"]*"', 'name="Hz" factor="1"'),
        "Hz of rad/s has the factor 1.0",
    ),
    (
        "a derivative has the unit",
        3,
        description('name="amplitude"', 'name="amplitude" derivative="1"'),
        "amplitude is in 1, the state startAngle in rad",
    ),
    (
        "a derivative has the unit",
        2,
        description('(name="amplitude".*?<Real )', r'\1derivative="2" '),
        "amplitude is in 1, the state startAngle in rad",
    ),
    (
        "value references are shared",
        3,
        description(
            r'name="gyroAngle" valueReference="\d+"', 'name="gyroAngle" valueReference="0"'
        ),
        r"seed, gyroAngle (Float64, Int32) share the value reference 0",
    ),
    (
        "value references are shared",
        2,
        description(
            r'(name="gyroAngle" valueReference=)"\d+"(.*?name="gyroRate" valueReference=)"\d+"',
            r'\1"9999"\2"9999"',
        ),
        "gyroAngle, gyroRate share the value reference 9999 and differ in unit",
    ),
    (
        "start values lie between",
        2,
        description('max="500.0" nominal="300.0"', 'max="200.0" nominal="300.0"'),
        "caseTemperature starts at 298.15, above its max 200.0",
    ),
    (
        "start values lie between",
        3,
        description('min="100.0" max="500.0"', 'min="300.0" max="500.0"'),
        "below its min 300.0",
    ),
    (
        "an array has a start value",
        3,
        description('<Dimension start="7" />', '<Dimension start="6" />'),
        "controller.biasMap.coefficients has 7 start values for 6 elements",
    ),
    (
        "an array has a start value",
        3,
        description('start="298.15"', 'start="298.15 298.15"'),
        "has 2 start values for 1 elements",
    ),
    (
        "an array has a start value",
        3,
        description('<Dimension start="7" />', '<Dimension valueReference="0" />'),
        "controller.biasMap.coefficients has the dimensions 0",
    ),
    ("min lies below max", 3, description('min="100.0"', 'min="1e4"'), "the min 1e4 above"),
    (
        "nominal values are above",
        2,
        description('nominal="300.0"', 'nominal="0"'),
        "nominal value 0",
    ),
]
