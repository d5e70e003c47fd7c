"""Storage: run directories, to write while a run trains and to read at any time.

`run_directory` holds the files of a run and says which of them a stage writes; `saved_run` opens a
run to look at it. Atomic writes, checksums and locks of single files are in
`matrixworld._util.files`.
"""
