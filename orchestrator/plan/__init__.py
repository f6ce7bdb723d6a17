"""What will be done: rates, transfers, order and every operation, as data that can be printed."""
