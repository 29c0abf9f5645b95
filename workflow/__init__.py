"""Parameter studies of elastomer friction: study -> plan -> dask -> statistics -> netCDF."""
