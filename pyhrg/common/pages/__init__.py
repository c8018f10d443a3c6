"""Pages of HTML: what their drawings and looks have in common."""
