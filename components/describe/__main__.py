"""Write the tables anew: variables into `fmus/README.md`, equations into the components' READMEs."""

from .tables import main

main()
