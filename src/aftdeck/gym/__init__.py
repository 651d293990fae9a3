"""Learning environments for Gymnasium: tasks of the arm, flown with the hand controllers that a person uses.

The import of this package registers the environments; ``gymnasium.make("aftdeck.gym:aftdeck/Reach-v0")`` imports it.
"""

from importlib.util import find_spec

if find_spec("gymnasium") is None:
    raise ModuleNotFoundError(
        "aftdeck.gym needs Gymnasium, which is not installed: pip install 'aftdeck[gym]'", name="gymnasium"
    )

from aftdeck.gym.registration import register_all

register_all()
