"""The user's cache folder, and which of its entries living processes need."""
