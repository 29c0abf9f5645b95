"""Physical effects of a scene: material, programme and quantities.

Plain data in SI units with checks of valid combinations. Depends on no later stage.
"""
