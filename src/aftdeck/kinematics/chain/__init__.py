"""General solver: kinematics of any chain of up to eight joints that turn or slide, each a compiled law.

It is the witness of the closed forms in `kinematics/`, which are faster, and of which there is one for each kind of
wrist. `posture` has poses and the Jacobian, `factors` the Jacobian's singular values, `rates` joint rates for a twist
and distances from singularities, `search` joint angles for a pose.
"""
