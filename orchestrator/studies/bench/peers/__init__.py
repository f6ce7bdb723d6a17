"""What steps our FMUs beside rovbrush: other masters, and loops of bare calls."""
