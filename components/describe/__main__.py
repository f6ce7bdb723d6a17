"""Write the tables anew: variables into `fmus/README.md`, equations into the components' READMEs.

With folders of other components as arguments: those of their READMEs.
"""

import sys

from ..errors import BuildError
from .tables import describe_component, main

try:
    for folder in sys.argv[1:]:
        print(describe_component(folder))
except (OSError, BuildError) as error:
    sys.exit(str(error))
if not sys.argv[1:]:
    main()
