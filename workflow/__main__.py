"""``python -m workflow`` in the repository: the console command ``elastomer-friction``.

Nothing is imported from the folder above but the package ``elastomer_friction``, which links to
this one: a module that were loaded by two names would have two classes of each name.
"""

import sys

from elastomer_friction.__main__ import main

if __name__ == "__main__":
    sys.exit(main())
