"""What is simulated: components, each written once as a kernel of equations and packaged as FMUs."""
