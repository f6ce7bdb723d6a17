"""What is handed out: wheel and source distribution, a zip of FMUs; and how long a stranger's first run takes."""
