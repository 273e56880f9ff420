"""What the kernels run on: compiled code, threads, lent memory, stores past the caches."""
