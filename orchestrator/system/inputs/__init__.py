"""Inputs that no connection drives: values that are held, and tables that are followed."""
