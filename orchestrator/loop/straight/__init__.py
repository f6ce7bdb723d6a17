"""A plan's operations one behind the other as machine code: what the loop looks up in every cycle is text here.

It holds no address, so that it is compiled once for all runs of a system; its bits are those of `run.run`."""
