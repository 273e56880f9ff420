"""Meeting in time when vehicles are late: chances, expected waits, when to give up."""
