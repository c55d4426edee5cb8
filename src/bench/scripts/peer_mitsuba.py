"""Renders a scene with Mitsuba 3: python3 src/bench/scripts/peer_mitsuba.py VARIANT SCENE.xml OUT.png (pip install mitsuba)"""
import pathlib
import sys

import mitsuba as mi

mi.set_variant(sys.argv[1])
if "hcconductor" in pathlib.Path(sys.argv[2]).read_text():
    import hcconductor

    hcconductor.register()
picture = mi.render(mi.load_file(sys.argv[2]))
mi.util.write_bitmap(sys.argv[3], picture)
