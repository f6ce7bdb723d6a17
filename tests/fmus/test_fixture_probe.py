from helpers import *
from pathlib import Path
import time
def test_probe(fmus, tmp_path):
    t=time.time()
    r = run_of(tmp_path, fmus, {"w": ("wheel","1 ms"), "c": ("chassis","1 ms")}, ["c.v_c -> w.v_c","w.F -> c.F"], stop="4 s", algorithm="jacobi")
    print(repr(last(r,"c.z_c")), time.time()-t, r.wall)
    for x in ("5 ms", "10 ms"):
        r = run_of(tmp_path, fmus, {"w": ("wheel",x), "c": ("chassis",x)}, ["c.v_c -> w.v_c","w.F -> c.F"], stop="4 s", algorithm="jacobi")
        print(repr(last(r,"c.z_c")))
