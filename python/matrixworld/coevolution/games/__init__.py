"""What is raced: games of two populations, and the settings of a race that speak of them."""
