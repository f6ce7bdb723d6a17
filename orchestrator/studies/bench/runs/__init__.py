"""What a run costs, part by part: its loop, its solvers, who looks on, runs of many."""
