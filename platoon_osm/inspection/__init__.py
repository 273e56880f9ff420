"""The independent checker of driving times: it reads a finished timetable and lists what is wrong.

It has the numbers of the law on its own, and knows nothing of how a plan was found.
"""
