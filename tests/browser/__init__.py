"""Tests in a browser. This file makes the folder a package, so that fixtures of the scope `package` end with it."""
