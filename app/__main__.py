"""``python -m app`` is ``burnish``."""

from app.cli import main

if __name__ == "__main__":
    main()
