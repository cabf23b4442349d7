"""Everything that is not code: bundled models, documents, icons."""
