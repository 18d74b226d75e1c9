"""Run the command line: `python -m qcone`."""

from qcone.cli import main

if __name__ == "__main__":
    main()
