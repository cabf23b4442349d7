"""What the program is doing now: the study, its results, undo. Plain Python, no Qt."""

from app.session.history import History
from app.session.jobs import Job, Jobs, Post
from app.session.meshes import Meshes
from app.session.running import RunningTasks, Task, TaskState
from app.session.runs import Run
from app.session.session import Session

__all__ = [
    "History",
    "Job",
    "Jobs",
    "Meshes",
    "Post",
    "Run",
    "RunningTasks",
    "Session",
    "Task",
    "TaskState",
]
