"""System Structure and Parameterization (SSP): systems that come from other tools and go to them."""
