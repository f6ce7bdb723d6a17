"""How far the force loop of a closed-loop system is from instability, measured on runs of it.

`open_loop` opens the loop along the normal by a small force, `limits` raises delay and gain until a kick no longer
decays, `table` shows both for the shipped pass: `python -m rovbrush.orchestrator.paper.margins [FMUS]`.
"""
