"""A system run over ranges of parameters: points, workers, one dataset."""
