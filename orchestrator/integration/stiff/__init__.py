"""CVODE of SUNDIALS, called by address."""
