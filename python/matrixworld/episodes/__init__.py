"""Recorded episodes: making, explaining, drawing and counting them."""
