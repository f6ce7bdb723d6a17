"""Operations of a plan as lines of C, and what each costs at most."""
