"""What the READMEs say of components, written from declarations and kernels: variables and equations."""
