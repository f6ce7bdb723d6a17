"""A body that is pushed through water."""
