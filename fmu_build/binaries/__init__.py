"""C to shared libraries, for each platform."""
