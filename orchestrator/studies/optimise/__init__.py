"""The best parameters of a system: an objective and constraints from figures of merit, within ranges."""
