"""What every room uses: checks of input, files, memory, colors."""
