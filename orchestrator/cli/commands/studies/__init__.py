"""Commands that run a system many times, and tell what came of it."""
