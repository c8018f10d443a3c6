"""One small function a rule."""
