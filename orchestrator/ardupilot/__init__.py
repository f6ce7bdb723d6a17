"""ArduPilot's SITL JSON interface as pure functions: servo packets, state lines, axes, servos, the order of frames.

Written from its public description (ArduPilot, libraries/SITL/examples/JSON/readme.md). Nothing here opens a socket.
"""
