"""Many runs: how fast they converge, how they depend on their parameters, what they cost."""
