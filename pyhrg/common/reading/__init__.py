"""The one boundary through which files enter: whatever fails in reading is one clear refusal.

No other module parses JSON, TOML, CSV, Parquet, XML or archives, or opens a user's file.
"""
