"""The keys themselves, each family in a file: of system files, sweeps, fits and mappings; and what values they take."""
