"""The rows of a run as they come: kept, streamed to disk, and seen by whoever looks on."""
