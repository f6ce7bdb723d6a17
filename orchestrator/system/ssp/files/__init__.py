"""The files of an SSP and what stands in them: archives and folders, XML, annotations, what breaks the standard."""
