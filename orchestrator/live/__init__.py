"""A run that is watched and touched while it goes: who drives it, what was done, what is posted, and the page."""
