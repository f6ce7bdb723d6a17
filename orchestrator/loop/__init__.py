"""The loop that steps the components: no Python in it, only calls by address and numbers in cells."""
