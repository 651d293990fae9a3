"""Colour of each material, for pictures without gloss or patterns."""

from __future__ import annotations

from aftdeck.scene.placed import Leaf
from aftdeck.shapes import Light, Material

COLOURS: dict[Material, str] = {
    "blanket": "#e2dfd7",
    "liner": "#cdcac1",
    "tiles": "#26272a",
    "leading_edge": "#6d6f72",
    "radiator": "#d5dade",
    "boom": "#efede7",
    "padding": "#d8d6cf",
    "housing": "#2c2e31",
    "bright": "#8a8d90",
    "dark": "#101113",
    "glass": "#07090c",
    "metal": "#b9bcbf",
    "foil": "#c9973f",
    "structure": "#9a978e",
    "silver": "#c3c7cc",
    "solar": "#6d86c9",
    "rail": "#d6a52c",
    "scuffed": "#d9d5cb",
    "glow": "#fff4de",
}
"""sRGB colours, equal to the page's colours (web/src/scene/materials.ts). The page adds gloss and patterns."""


def material_of(shape: Leaf) -> Material:
    """Return the material of a shape; "glow" for a lamp's face."""
    return "glow" if isinstance(shape, Light) else shape.material


def rgb(material: Material) -> tuple[float, float, float]:
    """Return the sRGB components red, green and blue of a material, each from 0 to 1."""
    number = int(COLOURS[material][1:], 16)
    return (number >> 16) / 255.0, (number >> 8 & 255) / 255.0, (number & 255) / 255.0
