"""The score of diagnoses against their truths."""
