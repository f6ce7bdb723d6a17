"""What the loop is given: the operations of a hyperperiod in their order, their coefficients, the memory that they work
on, and each of them in words."""
