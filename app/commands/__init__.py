"""The commands of the command line, one file each, listed in the order of the help.

Nothing heavy is imported before a command runs.
"""

from app.commands.compare import compare
from app.commands.doctor import doctor
from app.commands.methods import methods
from app.commands.skeleton import skeleton
from app.commands.stats import stats
from app.commands.study import study

COMMANDS = (compare, study, skeleton, stats, doctor, methods)

__all__ = ["COMMANDS", "compare"]
