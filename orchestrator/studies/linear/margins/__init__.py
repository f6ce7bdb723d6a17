"""How far a loop is from instability: broken at a connection, in frequency and in time, with its pictures."""
