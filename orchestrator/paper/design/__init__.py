"""What a designer asks: which brush, gains, sensors and thrust hold a force on a hull, and how sure that is."""
