"""Certifies critical points of your own: here saddles of index 1, by a rule that is nearly right."""

import flowcert

points = flowcert.generate("lattice-3", seed=3)
claim = []
for i in range(len(points)):
    for j in range(i):
        middle = (points[i] + points[j]) / 2
        squared_distances = ((points - middle) ** 2).sum(axis=1)
        if squared_distances.min() >= squared_distances[i]:  # should be: all others are farther
            claim.append({"index": 1, "center": middle, "squared_distance": squared_distances[i]})
print(flowcert.check(points, claim, indices=[1]))
