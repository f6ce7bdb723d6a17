"""What crosses the boundary of a component: written, read, replayed."""
