"""Which points are computed: axes and their values, grids, draws and blocks of them."""
