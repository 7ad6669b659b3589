# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of every class, by VTK's own conventions: what is set is got, clamped, printed, and told once."""
import math
import unittest

import vtkTerrainTesting

import vtkterrain

# Classes whose properties are those of VTK's own windows.
_WINDOWS = {"vtkTerrainOSMesaRenderWindow", "vtkTerrainEGLRenderWindow", "vtkTerrainOffscreenRenderWindow"}
# Read at every frame; actors switch them between frames, which is no change of the terrain.
_OF_FRAMES = {"HastyTolerance", "WaitForTiles"}
# Set together with another value.
_IN_PAIRS = {"vtkTerrainGeoreference.Zone"}
# Old names of other properties, which warn.
_OLD_NAMES = {"SamplesPerQuad", "LevelColors"}


def classes():
    """The classes that can be made, with their names."""
    for name in vtkterrain.__all__:
        member = getattr(vtkterrain, name)
        if not isinstance(member, type) or name in _WINDOWS:
            continue
        try:
            member()
        except (TypeError, NotImplementedError):
            continue
        yield name, member


def own(member, prefix):
    """Names of the properties for which the class itself has a method with a prefix."""
    return sorted(method[len(prefix):] for method in vars(member) if method.startswith(prefix))


def properties(member):
    """Names of the properties that the class itself sets and gets without an argument, with their values."""
    for name in set(own(member, "Set")) & set(own(member, "Get")) - _OLD_NAMES:
        try:
            yield name, getattr(member(), f"Get{name}")()
        except TypeError:
            continue


def others(value):
    """Other values of the same kind; none for what cannot be made up."""
    if isinstance(value, bool):
        return [not value]
    if type(value) is int:
        return [value + 1, value - 1, 2 * value + 7]
    if isinstance(value, float):
        return [0.5 * value + 0.25, 0.75, 2.0 * value + 1.5] if math.isfinite(value) else [1.5]
    if isinstance(value, str):
        return ["name of nothing"]
    if isinstance(value, tuple) and value and all(isinstance(each, (int, float)) for each in value):
        if not all(math.isfinite(each) for each in value):
            return []
        return [tuple(each + type(each)(k + 1) for k, each in enumerate(value))]
    if isinstance(value, int):  # of an enumeration
        return [each for each in _enumerators(type(value)) if each != value]
    return []


def _enumerators(kind):
    """The values of an enumeration, which only its class knows."""
    for _, member in classes():
        if kind in vars(member).values():
            return [each for each in vars(kind).values() if isinstance(each, kind)]
    return []


def changed(thing):
    """When a thing has changed; looks have a time of their own, which mappers and actors tell beside theirs."""
    times = ("GetMTime", "GetLookTime", "GetRedrawMTime")
    return max(getattr(thing, time)() for time in times if hasattr(thing, time))


def set_value(thing, name, value):
    setter = getattr(thing, f"Set{name}")
    try:
        setter(value)
    except TypeError:
        setter(*value)


class TestProperties(unittest.TestCase):
    def test_what_is_set_is_got_and_told(self):
        count = 0
        for name, member in classes():
            for each, default in properties(member):
                if f"{name}.{each}" in _IN_PAIRS:
                    continue
                for value in others(default):
                    with self.subTest(property=f"{name}.{each}", value=value):
                        thing = member()
                        before = changed(thing)
                        set_value(thing, each, value)
                        got = getattr(thing, f"Get{each}")()
                        lowest = getattr(thing, f"Get{each}MinValue", lambda value=value: value)()
                        highest = getattr(thing, f"Get{each}MaxValue", lambda value=value: value)()
                        is_clamped = not isinstance(value, tuple) and not lowest <= value <= highest
                        expected = min(max(value, lowest), highest) if is_clamped else value
                        if got == default != expected:
                            continue  # refused: those have tests of their own
                        self.assertEqual(got, expected)
                        count += 1
                        if got == default or each in _OF_FRAMES:
                            continue
                        after = changed(thing)
                        self.assertGreater(after, before)
                        set_value(thing, each, value)
                        self.assertEqual(changed(thing), after, "the same value once more is no change")
        self.assertGreater(count, 150)

    def test_ranges_hold(self):
        count = 0
        for name, member in classes():
            for each in own(member, "Set"):
                if not hasattr(member, f"Get{each}MinValue"):
                    continue
                with self.subTest(property=f"{name}.{each}"):
                    thing = member()
                    setter, getter = (getattr(thing, f"{verb}{each}") for verb in ("Set", "Get"))
                    lowest = getattr(thing, f"Get{each}MinValue")()
                    highest = getattr(thing, f"Get{each}MaxValue")()
                    self.assertLessEqual(lowest, getter())
                    self.assertLessEqual(getter(), highest)
                    for bound, step in ((lowest, -1), (highest, 1)):
                        setter(bound)
                        self.assertEqual(getter(), bound)
                        beyond = bound + step * (1 if isinstance(bound, int) else 1.0 + abs(bound))
                        if isinstance(bound, float) and not math.isfinite(beyond):
                            continue
                        try:
                            setter(beyond)
                        except OverflowError:
                            continue
                        self.assertEqual(getter(), bound)
                    count += 1
        self.assertGreater(count, 30)

    def test_switches_switch(self):
        count = 0
        for name, member in classes():
            for each in own(member, "Set"):
                if not hasattr(member, f"{each}On") or each in _OLD_NAMES:
                    continue
                with self.subTest(property=f"{name}.{each}"):
                    thing = member()
                    for word, expected in (("On", True), ("Off", False), ("On", True)):
                        getattr(thing, f"{each}{word}")()
                        self.assertEqual(bool(getattr(thing, f"Get{each}")()), expected)
                    count += 1
        self.assertGreater(count, 20)

    def test_all_are_printed(self):
        for name, member in classes():
            words = str(member())
            text = "".join(words.split()).lower()
            for each, _ in properties(member):
                with self.subTest(property=f"{name}.{each}"):
                    self.assertIn(each.lower(), text)


if __name__ == "__main__":
    vtkTerrainTesting.run()
