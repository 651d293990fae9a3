import re
from pathlib import Path
from typing import get_args

from aftdeck.scene.colours import COLOURS, material_of, rgb
from aftdeck.shapes import Light, Material, Sphere

PAGE = Path(__file__).parents[2] / "web" / "src" / "scene" / "materials.ts"


def test_colours_equal_those_of_the_page() -> None:
    page = dict(re.findall(r"(\w+): look\('(#[0-9a-f]{6})'", PAGE.read_text(encoding="utf-8")))
    assert page == COLOURS
    assert set(COLOURS) == set(get_args(Material))


def test_rgb_components_are_fractions_of_one() -> None:
    assert rgb("foil") == (201 / 255, 151 / 255, 63 / 255)


def test_lamp_face_has_the_glow_material() -> None:
    assert material_of(Light(radius=0.2, cone=1.0, reach=1.0, intensity=1.0)) == "glow"
    assert material_of(Sphere(material="foil", radius=1.0)) == "foil"
