"""Pages that show runs and play their matches, with the engine inside."""
