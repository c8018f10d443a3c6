"""Linear error model of the navigator (docs/methods/error_model.md)."""
