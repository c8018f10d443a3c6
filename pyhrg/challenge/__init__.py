"""The challenge: campaigns with a sealed truth, and the score of their diagnoses
(docs/methods/challenge.md)."""
