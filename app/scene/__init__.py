"""Meshes, fields and graphs as PyVista actors; used by the window and by headless pictures."""
