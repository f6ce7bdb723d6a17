"""Events of a group: where indicators change, and the rounds in which all members come to new discrete states."""
