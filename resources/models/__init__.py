"""The bundled models (``*.ply``) and the scripts that make them."""
