"""Every command of the window, declared once: menus, toolbar, shortcuts and tips come from here."""

from dataclasses import dataclass

from app.export.statistics_plots import PLOTS
from app.scene.camera import PRESETS
from core.io import bundled_samples
from core.metrics import METRICS
from core.smoothing import METHODS


@dataclass(frozen=True)
class Command:
    """A command: its name, its place in the menus, its key and what it does.

    Attributes
    ----------
    id : str
        Name in code.
    menu : str
        Menu it stands in; submenus after a slash.
    text : str
        Name in the menu.
    tip : str
        One line for the tooltip and the status bar.
    key : str
        Shortcut.
    icon : str
        Name of a qtawesome icon, for commands on the toolbar.
    checkable : bool
        Whether it switches something on and off.
    divided : bool
        Whether a line stands above it in the menu.
    group : str
        Commands of one group are choices, of which one is checked.
    """

    id: str
    menu: str
    text: str
    tip: str
    key: str = ""
    icon: str = ""
    checkable: bool = False
    divided: bool = False
    group: str = ""


TABS = ("Denoise", "Skeleton", "Statistics")
"""Titles of the tabs."""

PANELS = {
    "Model and noise": "Denoise", "Methods": "Denoise", "Error": "Denoise", "Table": "Denoise",
    "Views": "Skeleton", "Graph": "Skeleton",
}  # fmt: skip
"""Tabs of the panels that can be hidden, by title."""

COLOURS = {"none": "Nothing"} | {id_: spec.heat_title for id_, spec in METRICS.items()}
"""What can colour the panes, by id."""

COMPARED = {"original": "Original", "noisy": "Noisy input"} | {
    id_: spec.title for id_, spec in METHODS.items()
}
"""Panes that the selected one can be compared with, by id."""

THEMES = {"system": "System", "light": "Light", "dark": "Dark"}

COMMANDS = (
    Command("open", "File", "&Open…", "Open a model to compare the methods on, or a study",
            "Ctrl+O", "mdi6.folder-open-outline"),
    Command("open_study", "File", "Open St&udy…", "Open a study that was saved", "Ctrl+Alt+O"),
    *(Command(f"sample_{sample.id}", "File/Open &Sample", sample.title,
              f"Open the bundled model {sample.title}") for sample in bundled_samples()),
    Command("gallery", "File", "&Gallery…", "Bundled models, and PyVista's to download", "Ctrl+G"),
    Command("open_noisy", "File", "Separate &Noisy File…",
            "Use a noisy file of the same model instead of adding noise", "Ctrl+Shift+O"),
    Command("save_study", "File", "&Save Study", "Save the study: models, noise, methods, views",
            "Ctrl+S", "mdi6.content-save-outline", divided=True),
    Command("save_study_as", "File", "Save Study &As…", "Save the study under another name",
            "Ctrl+Shift+S"),
    Command("save_packed", "File", "Save Study Pac&ked…",
            "Save the study with its models inside, to give it away"),
    Command("save_mesh", "File/E&xport", "&Mesh…",
            "Save the mesh of the selected view as PLY, OBJ, OFF or STL", "Ctrl+M"),
    Command("figure", "File/E&xport", "&Figure…",
            "Arrange views with captions as PNG, PDF or TIFF, in centimetres", "Ctrl+Shift+F"),
    Command("screenshot", "File/E&xport", "&Screenshot…",
            "Save a view, all views or the window as PNG", "Ctrl+P", "mdi6.camera-outline"),
    Command("save_plot", "File/E&xport", "&Plot…", "Save the large plot as SVG, PDF or PNG",
            "Ctrl+E", divided=True),
    Command("save_table", "File/E&xport", "&Table…", "Save the table as CSV, Markdown or LaTeX",
            "Ctrl+Shift+E"),
    Command("save_graph", "File/E&xport", "Skeletal &Graph…",
            "Save the graph of the selected view as GraphML, JSON, OBJ or CSV", "Ctrl+Shift+G",
            divided=True),
    Command("save_film", "File/E&xport", "&Animation of the Graph…",
            "Save a full turn, or the growth of the graph, as a film (GIF or video)", "Ctrl+Alt+F"),
    *(Command(f"save_plot_{id_}", "File/E&xport/Statistics P&lot", f"{spec.title}…",
              f"Save the plot as SVG, PDF or PNG: {spec.title}") for id_, spec in PLOTS.items()),
    Command("save_matrix", "File/E&xport/Statistics P&lot", "Matrix…",
            "Save the matrix that is shown, as a picture, Matrix Market or NPZ"),
    Command("save_statistics", "File/E&xport", "Statistics &Bundle…",
            "Save all plots, tables and numbers of the model into a folder", "Ctrl+Shift+B"),
    Command("quit", "File", "&Quit", "Close Burnish", "Ctrl+Q", divided=True),
    Command("undo", "Edit", "&Undo", "Take back the last step", "Ctrl+Z", "mdi6.undo"),
    Command("redo", "Edit", "&Redo", "Do the step again that was taken back", "Ctrl+Shift+Z",
            "mdi6.redo"),
    Command("doctor", "Edit", "Mesh &Doctor…",
            "What is wrong with the model, holes for one, what that means, and repairs", "Ctrl+D",
            divided=True),
    Command("copy_table", "Edit", "&Copy Table", "Copy the table as text", "Ctrl+Shift+C",
            divided=True),
    Command("copy_command", "Edit", "Copy as Command &Line",
            "Copy the command that carries out this study without a window"),
    Command("copy_script", "Edit", "Copy as Python &Script",
            "Copy a script that carries out this study with Burnish's core"),
    Command("copy_camera", "Edit", "Copy C&amera", "Copy where the camera stands, as text",
            "Ctrl+Alt+C"),
    Command("paste_camera", "Edit", "Paste Ca&mera", "Put the camera where a copied text says",
            "Ctrl+Alt+V"),
    Command("preferences", "Edit", "&Preferences…", "Theme, memory, keys, reset to defaults",
            "Ctrl+,", divided=True),
    *(Command(f"tab_{place}", "View/Ta&b", f"&{title}", f"Show the {title} tab", f"Ctrl+{place}",
              checkable=True, group="tab") for place, title in enumerate(TABS, start=1)),
    Command("smooth_shading", "View", "&Smooth Shading", "Smooth shading; off shows flat faces",
            "S", checkable=True),
    Command("edges", "View", "&Edges",
            "Draw the edges of the triangles, as a wireframe on the surface", "W", checkable=True),
    Command("link", "View", "&Link Cameras", "Move the cameras of all panes together", "L",
            "mdi6.link-variant", checkable=True),
    Command("enlarge", "View", "Enlarge &Pane", "Enlarge the selected pane, or bring all back",
            "E", divided=True),
    Command("reset_view", "View", "&Whole Model", "Show the whole model again", "R"),
    Command("box_zoom", "View", "&Box Zoom", "Drag a rectangle to zoom into", "B",
            "mdi6.magnify-scan", checkable=True),
    Command("fly", "View", "&Fly to Cursor", "Fly to the point under the cursor", "F"),
    *(Command(f"look_{key}", "View/Look F&rom", name, f"Show the whole model: {name}", str(key))
      for key, name in enumerate(PRESETS, start=1)),
    Command("save_camera", "View/&Cameras", "&Save Camera…", "Save the camera under a name",
            "Ctrl+Alt+S"),
    Command("restore_camera", "View/&Cameras", "&Restore Camera…",
            "Put the camera back to where one was saved under a name", "Ctrl+Alt+R"),
    Command("forget_camera", "View/&Cameras", "&Forget Camera…", "Forget a camera that was saved"),
    Command("flicker", "View/Co&mpare Panes", "&Flicker (Hold the Key)",
            "While held, the selected pane shows the mesh it is compared with", "X"),
    Command("swipe", "View/Co&mpare Panes", "&Swipe Line",
            "Part one pane by a line to drag: left the one, right the other", "D",
            checkable=True),
    *(Command(f"compare_{id_}", "View/Co&mpare Panes/&With", title,
              f"Compare the selected pane with this one: {title}", checkable=True,
              group="compare") for id_, title in COMPARED.items()),
    Command("difference", "View", "&Distance to the Original",
            "Heat map of each vertex' distance to where it was in the original", "H",
            checkable=True, divided=True),
    Command("colour_bar", "View", "Colour &Bar…",
            "Range, colours, direction and histogram of the heat map", "C"),
    *(Command(f"colour_{id_}", "View/&Colour by", title, f"Colour the panes by: {title.lower()}",
              checkable=True, group="colour") for id_, title in COLOURS.items()),
    *(Command(f"theme_{id_}", "View/&Theme", title, f"Colours of the window: {title.lower()}",
              checkable=True, group="theme") for id_, title in THEMES.items()),
    *(Command(f"panel_{title}", "View/P&anels", title, f"Show the panel {title}, or hide it",
              checkable=True) for title in PANELS),
    Command("reset_panels", "View/P&anels", "&Put All Back",
            "Put all panels of the tab back where they were at the first start", divided=True),
    Command("advance", "Run", "Five &More Iterations", "Run every checked method five steps on",
            "Ctrl+R", "mdi6.play-outline"),
    Command("cancel", "Run", "&Cancel", "Stop what is being computed", "Esc",
            "mdi6.stop-circle-outline"),
    Command("tasks", "Run", "What &Runs…", "List all that runs, with the time left", "Ctrl+J"),
    Command("palette", "Help", "&Find a Command…", "Search all commands by name and run one",
            "Ctrl+Shift+P"),
    Command("shortcuts", "Help", "&Keyboard Shortcuts", "All keys and mouse gestures", "?"),
    Command("methods", "Help", "&Reference", "Formulas, parameters and sources", "F1",
            divided=True),
    Command("errata", "Help", "Where the &Printed Thesis Fails",
            "What Burnish does differently, and why"),
    Command("log", "Help", "Show the &Log File", "What happened, for a bug report"),
    Command("about", "Help", "&About Burnish", "Versions, for a bug report", divided=True),
)  # fmt: skip

TOOLBAR = ("open", None, "undo", "redo", None, "advance", "cancel", None, "link", "box_zoom", None,
           "screenshot")  # fmt: skip
"""Commands on the toolbar, with None for a gap."""

NEED_MODEL = (
    "doctor", "save_study", "save_study_as", "save_packed", "save_mesh", "save_plot", "save_table",
    "copy_table", "figure", "screenshot", "advance", "copy_command", "copy_script", "flicker",
    "swipe", "copy_camera", "paste_camera", "save_camera", "restore_camera", "forget_camera",
    "save_graph", "save_film", "save_statistics", "save_matrix", "enlarge", "reset_view",
    "box_zoom", "fly",
    *(f"save_plot_{id_}" for id_ in PLOTS),
    *(f"compare_{id_}" for id_ in COMPARED),
    *(f"look_{key}" for key in range(1, len(PRESETS) + 1)),
)  # fmt: skip
"""Commands that need a model."""
