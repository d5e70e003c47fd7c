"""What every room uses: checks of input, files, memory, colors."""

from matrixworld._util import browser as browser  # before anything imports Gymnasium
