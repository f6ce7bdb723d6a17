"""What `rovbrush check` looks at: archive, description, other tools' opinions, and a dry run in processes of its own."""
