"""The files of an FMU: an archive or an unpacked folder, checked, and kept where its library can be loaded."""
