"""What a component says of itself: its variables and the records that its equations read and write."""
