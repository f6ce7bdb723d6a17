"""Who computes the points: processes on this machine or a Dask cluster, one point after the other in each."""
