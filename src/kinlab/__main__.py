"""`python -m kinlab`."""

from kinlab.cli import main

main()
