"""What drivers take along: a printed sheet of their journey, and a calendar of it."""
