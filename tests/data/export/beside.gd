extends Exercise
