"""What is simulated: four components, each written once as a plain numeric kernel and packaged as an FMU."""
