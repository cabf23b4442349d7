"""The Burnish program: command line and window over :mod:`core`."""
