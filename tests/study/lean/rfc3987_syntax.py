"""Stand-in for a package of this name, on the path of Ray's processes in the tests.

The check of the wheel's SBOM installs that package. Ray imports it where it is installed, through jsonschema, and each
process then builds its grammar for seconds. A busy machine so misses the 15 s after which a node of Ray gives up.
"""

raise ImportError("left out in Ray's processes")
