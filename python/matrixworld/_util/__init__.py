"""What every room uses: checks of input and sizes, files, imports, texts of results, colors."""
