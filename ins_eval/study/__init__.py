"""The study: do bench figures predict navigation error? Many gyros, many manoeuvres."""
