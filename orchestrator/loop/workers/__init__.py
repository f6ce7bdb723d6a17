"""Steps of FMUs on worker threads: machine code stands in the place of DoStep in the table of components.
The loop does not know: a call of the first of a group posts the others, a call of one of those gives its status."""
