"""The command line: its commands by family, their options, what a person sees."""
