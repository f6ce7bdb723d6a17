"""Linear models of systems that run: A, B, C, D at operating points, and the margins of a loop that is broken.

`linearise` and `margins` are the studies; `realise` makes states of pulse responses, `by_states` of derivatives.
"""
