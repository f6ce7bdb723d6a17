"""The test bench for single components: is this FMU what that component is, on its interface and in its behaviour?"""
