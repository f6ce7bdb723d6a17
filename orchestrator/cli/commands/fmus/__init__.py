"""Commands for FMUs by themselves: looked into, judged, driven, given to others."""
