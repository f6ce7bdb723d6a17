"""Behaviour tests: what a component does on its interface, whoever made it."""
