"""The page of `rovbrush reproduce`: sections, figures and the frame that holds them."""
