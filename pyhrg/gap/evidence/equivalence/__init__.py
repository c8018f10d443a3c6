"""What the records can't tell apart: effects in the place of others, or hidden beside them."""
