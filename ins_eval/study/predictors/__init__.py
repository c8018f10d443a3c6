"""What bench figures say of the position error that triads will have: from simple to best."""
