"""The still map of a document: its view, its routes and marks, and room for its texts."""
