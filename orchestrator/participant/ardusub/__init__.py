"""An autopilot in the loop: ArduPilot's SITL JSON protocol at a UDP port, in lock-step with the run."""
