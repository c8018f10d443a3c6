"""A laboratory's own logs, made a campaign by a mapping of their columns and units."""

from pyhrg.records.campaign_import.drafting.draft import draft_mapping
from pyhrg.records.campaign_import.importing import ImportedCampaign, import_campaign

__all__ = ["ImportedCampaign", "draft_mapping", "import_campaign"]
