"""A laboratory's own logs, made a campaign by a mapping of their columns and units."""

from pyhrg.records.campaign_import.draft import draft_mapping
from pyhrg.records.campaign_import.importing import ImportedCampaign, import_campaign
from pyhrg.records.campaign_import.mapping import CampaignMapping, read_mapping

__all__ = [
    "CampaignMapping",
    "ImportedCampaign",
    "draft_mapping",
    "import_campaign",
    "read_mapping",
]
