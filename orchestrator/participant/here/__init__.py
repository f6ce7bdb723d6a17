"""Instances whose library is in this process: what fmpy does for each version of FMI, their messages and their end."""
