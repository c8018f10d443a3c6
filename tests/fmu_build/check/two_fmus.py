"""A system of two FMUs (SSP): the gyro's halves, one connection, one parameter set."""

import zipfile
from pathlib import Path

from fmu_build import build_fmu
from fmu_build.archive.ssp import SPACES

PLANT, ELECTRONICS = "HRGPlant", "HRGElectronics"
STRUCTURE = f"""<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription xmlns:ssd="{SPACES["ssd"]}" xmlns:ssc="{SPACES["ssc"]}"
  name="two" version="1.0">
  <ssd:System name="system">
    <ssd:Connectors>
      <ssd:Connector name="rate" kind="input"><ssc:Real unit="rad/s"/></ssd:Connector>
    </ssd:Connectors>
    <ssd:Elements>
      <ssd:Component name="plant" source="resources/{PLANT}.fmu">
        <ssd:Connectors>
          <ssd:Connector name="angularRate" kind="input"><ssc:Real unit="rad/s"/></ssd:Connector>
          <ssd:Connector name="reference" kind="input"/>
        </ssd:Connectors>
        <ssd:ParameterBindings>
          <ssd:ParameterBinding source="resources/plant.ssv"/>
        </ssd:ParameterBindings>
      </ssd:Component>
      <ssd:Component name="electronics" source="resources/{ELECTRONICS}.fmu">
        <ssd:Connectors>
          <ssd:Connector name="reference" kind="output"><ssc:Real unit="rad/s"/></ssd:Connector>
        </ssd:Connectors>
      </ssd:Component>
    </ssd:Elements>
    <ssd:Connections>
      <ssd:Connection startConnector="rate" endElement="plant" endConnector="angularRate"/>
      <ssd:Connection startElement="electronics" startConnector="reference"
        endElement="plant" endConnector="reference"/>
    </ssd:Connections>
  </ssd:System>
</ssd:SystemStructureDescription>
"""
VALUES = f"""<?xml version="1.0" encoding="UTF-8"?>
<ssv:ParameterSet xmlns:ssv="{SPACES["ssv"]}" version="1.0" name="values">
  <ssv:Parameters>
    <ssv:Parameter name="startAngle"><ssv:Real value="0.1"/></ssv:Parameter>
  </ssv:Parameters>
</ssv:ParameterSet>
"""


def write(folder: Path, structure: str = STRUCTURE, values: str = VALUES) -> Path:
    path = folder / "two.ssp"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("SystemStructure.ssd", structure)
        archive.writestr("resources/plant.ssv", values)
        for name in (PLANT, ELECTRONICS):
            archive.write(build_fmu(name), f"resources/{name}.fmu")
    return path
