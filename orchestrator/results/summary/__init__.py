"""What the rows of a run come to: figures of merit, energies, how the coupling did."""
