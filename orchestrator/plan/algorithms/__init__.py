"""One class per algorithm that couples the components."""
