"""What `rovbrush bench` measured, as tables: by the parts that it measured."""
