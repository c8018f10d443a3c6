"""Level gyros whose patterns are started where their maps say the error is least."""
