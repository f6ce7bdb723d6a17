"""What happens between two runs of the loop: events, at the instants of the plan and between them."""
