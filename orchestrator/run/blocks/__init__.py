"""The loop, called for blocks of cycles: with which operations, by which code, on how many threads."""
