"""The report of a campaign's diagnosis: one HTML page, a summary for the terminal, its folder."""
