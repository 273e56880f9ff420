"""The languages of pages: one file of texts for each, and numbers and dates in its form."""
