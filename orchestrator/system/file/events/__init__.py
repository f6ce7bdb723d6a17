"""The events of a system file: when they happen, what they set, what they break."""
