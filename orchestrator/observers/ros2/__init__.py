"""Messages of ROS 2 without ROS: their definitions as text, and their bytes (CDR)."""
