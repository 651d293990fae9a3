"""A pilot that knows of the page only what a screen reader says, and that only presses keys.

`python -m tests.browser.text_pilot [SCENARIO ...]` flies scenarios and prints a report. What the pilot cannot do, an
operator cannot do either who cannot see the page: then the page or the text of the step lacks something.
"""
