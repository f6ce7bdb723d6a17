"""The states of FMUs for Model Exchange from one communication point to the next: their derivatives, events and loops,
with a one-step method or CVODE. All is called by address; no Python runs in a step."""
