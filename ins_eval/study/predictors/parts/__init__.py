"""What predictors share."""
