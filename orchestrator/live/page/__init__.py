"""The page's server: it hears of the run, shows it to viewers, and hands on what the one who drives it wants."""
