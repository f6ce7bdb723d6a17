"""What theory and other people's measurements say, without a run: beams, blades, the elastica, published numbers."""
