"""``python -m workflow`` in the repository: the console command ``elastomer-friction``.

Only the package ``elastomer_friction``, which links to this folder, is imported: a module loaded
under two names would define each of its classes twice.
"""

import sys

from elastomer_friction.__main__ import main

if __name__ == "__main__":
    sys.exit(main())
