"""The ready devices as parameter sets, which every FMU of the library holds.

`fmu_build` knows no devices: the sets are files of its own, which
`python -m tests.agreement.parameter_sets` writes anew from the devices."""

from importlib.resources import files
from pathlib import Path

from pyhrg.common.files import write_whole
from pyhrg.device.parameter_set import format_parameter_set
from pyhrg.device.ready_devices import READY, load_device

FOLDER = Path(str(files("fmu_build") / "archive" / "devices"))


def main() -> None:
    """Write all sets anew."""
    for name in READY:
        text = format_parameter_set(load_device(name))
        write_whole(FOLDER / f"{name}.ssv", text.encode())


if __name__ == "__main__":
    main()
