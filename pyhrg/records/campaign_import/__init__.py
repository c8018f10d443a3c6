"""A lab's own logs, made a campaign by a mapping of their columns and units."""

from pyhrg.records.campaign_import.importing import Imported, ImportedTest, imported
from pyhrg.records.campaign_import.mapping import CampaignMapping, read_mapping

__all__ = ["CampaignMapping", "Imported", "ImportedTest", "imported", "read_mapping"]
