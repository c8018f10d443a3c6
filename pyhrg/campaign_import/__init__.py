"""A lab's own logs, made a campaign by a mapping of their columns and units."""

from pyhrg.campaign_import.importing import Imported, ImportedTest, imported
from pyhrg.campaign_import.mapping import CampaignMapping, read_mapping

__all__ = ["CampaignMapping", "Imported", "ImportedTest", "imported", "read_mapping"]
