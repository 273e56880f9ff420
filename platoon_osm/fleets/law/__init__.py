"""Fleets within the law of driving hours: breaks and rests in every truck's timetable."""
