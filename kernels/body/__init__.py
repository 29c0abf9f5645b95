"""Bodies: elements under a surface, with steps that are attempted before they are accepted.

A body holds the constants and the memory of its elements. ``attempt`` finds the contact of one
time step, as often as the driver needs to find the step, and ``accept`` makes the last attempt the
new state. A driver proposes the steps: a prescribed motion (scene/march_body.py), or a spring that
pulls a slider (drive/slider_step.py). The bodies are a line of elements (element_line.py, the
reference), a line of Prony elements in blocks (quick/blocks) and a map on a half-space
(half_space/moved_map.py).
"""
