"""TOML with what tomllib does not do: where a key stands, and values written so that they are read back."""
