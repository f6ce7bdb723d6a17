"""What is to be run: components, connections and settings, read from a file and checked."""
