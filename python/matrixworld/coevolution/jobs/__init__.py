"""Jobs: the runs that were asked for together, played here, side by side or on other machines."""
