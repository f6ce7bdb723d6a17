"""Commands that tell what an installation has: shipped systems and documents, keys of files, its cache and tools."""
