"""Content policy of a page that is one file: what a browser lets the page do."""

from __future__ import annotations

import base64
import hashlib


def hash_source(text: str) -> str:
    """Return the source of a content policy that allows an inline script or style with this text, and no other."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def content_policy(*allowed: str) -> str:
    """Return the policy that forbids everything but `allowed`, and pictures inside the file."""
    return "; ".join(["default-src 'none'", *allowed, "img-src data:", "base-uri 'none'", "form-action 'none'"])
