"""Skeletal graphs: levels, bands, graph."""
