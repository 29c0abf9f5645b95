"""Tests of the program, with one thread per process as in its command and workers."""

import os

from elastomer_friction.workflow.system import THREADS

os.environ.update(THREADS)  # before numpy is imported
