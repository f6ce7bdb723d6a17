"""The keys of the files that people write, declared once: from here they are checked, and the JSON schema and the
reference page are made."""
