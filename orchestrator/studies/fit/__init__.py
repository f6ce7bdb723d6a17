"""Parameters of any system from measured data: what is compared, nonlinear least squares, and how sure it all is."""
