"""OspSystemStructure.xml: systems of the Open Simulation Platform, with groups of variables and functions."""
