"""The paper that the shipped systems come from: its numbers fitted, its claims answered."""
