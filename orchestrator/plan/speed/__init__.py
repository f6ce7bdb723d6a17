"""Operations that are done in one go, and which of them get machine code of their own: faster, with the same bits."""
