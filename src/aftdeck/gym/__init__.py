"""Learning environments for Gymnasium: tasks of the arm, flown with the hand controllers that a person uses.

The import of this package registers the environments; ``gymnasium.make("aftdeck.gym:aftdeck/Reach-v0")`` imports it.
"""

from aftdeck.gym.registration import register_all

register_all()
