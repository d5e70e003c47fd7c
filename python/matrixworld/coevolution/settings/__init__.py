"""Settings of a race: schedules, and the defaults that follow from what was chosen."""
