"""What a model description is read into: variables and units, clocks, states, terminals."""
