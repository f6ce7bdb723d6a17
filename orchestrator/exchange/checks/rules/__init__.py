"""The rules of `rovbrush check`, a function each."""
