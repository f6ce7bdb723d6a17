"""How a run ends before its stop: a failure, a component that asks to, a signal."""
