"""What is asked and what is answered: immutable records, and how they are read aloud."""
