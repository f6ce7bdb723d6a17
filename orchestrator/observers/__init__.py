"""Where rows go while a run makes them, beside its results: files for other tools, and programs that look on.

A thread of its own feeds each; the loop waits for none of them. See `watched.py`."""
