"""Jobs: runs that were asked for together."""
