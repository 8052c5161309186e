"""The figures that scripts/figures makes, one module each. Everything drawn comes from the program's output."""
