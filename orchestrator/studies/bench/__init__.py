"""What the master costs, beside other masters and the bare calls."""
