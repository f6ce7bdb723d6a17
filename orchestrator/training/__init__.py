"""Any system as an environment of Gymnasium: actions, observations and rewards by the names of signals, with resets
through saved states of the FMUs."""
