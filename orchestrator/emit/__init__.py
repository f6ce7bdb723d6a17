"""A plan as C: a library and a program, or one native FMU, linked with the C of its components; `code/` makes the text,
`sources/` is what all systems share, the rest is what belongs to files and compilers."""
