"""Participants that are no FMU, run: the calls that the loop makes by address, and what is behind them."""
