"""Descriptions as strangers write them: what a run can do without is mended and noted, never refused."""
