"""What both modules share; knows nothing of Slicer."""
