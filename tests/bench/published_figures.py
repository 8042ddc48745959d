"""The figures that the paper published: its Tables 2 to 5, as printed there (Cazals, Parameswaran, Pion 2008).

They were measured with CGAL 3.3 and its lazy kernel on a Pentium 4 of 3 GHz. An x is a run that did not end in 3 hours.
"""

# name, tag, points, indices 0 to 3, Euler, t_D in seconds, t_FC/t_D, megabytes
TABLE_2 = (
    ("schale", "S2", 2714, (2714, 6126, 4341, 928), 1, 1.03, 2.11, 40.35),
    ("schale", "U2", 2714, (2714, 6126, 4341, 928), 1, 0.38, 13.74, 36.75),
    ("Mecanic", "S2", 12593, (12593, 31632, 21886, 2846), 1, 2.30, 4.29, 103.85),
    ("Mecanic", "U2", 12593, (12593, 31632, 21886, 2846), 1, 2.31, 63.57, 95.11),
    ("BootSki", "S2", 33711, (33711, 69097, 35441, 54), 1, 8.90, 1.59, 158.99),
    ("BootSki", "U2", 33711, (33711, 69097, 35441, 54), 1, 8.81, 728.84, 227.15),
    ("Fish", "S2", 54811, (54811, 175327, 141219, 20702), 1, 13.64, 2.12, 386.03),
    ("Culbuteur", "S2", 71150, (71150, 208584, 138445, 1010), 1, 15.40, 2.36, 386.07),
    ("blade150k", "S2", 150001, (150001, 392200, 324361, 82161), 1, 23.04, 6.29, 1235.67),
    ("buddha", "S2", 542548, (542548, 1192588, 672270, 22229), 1, 159.35, 3.62, 2520.77),
)

# name, statistic, mean, max, stddev, mode, median
TABLE_3 = (
    ("schale", "S2", 2.20, 24, 2.47, 1, 1),
    ("schale", "U2", 7.87, 40, 7.54, 1, 5),
    ("schale", "WCC", 5.55, 40, 6.39, 1, 1),
    ("Mecanic", "S2", 2.10, 20, 2.20, 1, 1),
    ("Mecanic", "U2", 13.69, 88, 13.86, 1, 10),
    ("Mecanic", "WCC", 8.55, 88, 11.35, 1, 1),
    ("BootSki", "S2", 1.55, 13, 0.86, 1, 1),
    ("BootSki", "U2", 48.22, 207, 26.83, 42, 47),
    ("BootSki", "WCC", 35.48, 207, 27.92, 1, 17),
    ("Fish", "S2", 1.31, 164, 4.11, 1, 1),
    ("Culbuteur", "S2", 1.35, 106, 3.50, 1, 1),
    ("blade150k", "S2", 2.29, 76, 2.71, 1, 1),
)

# The operation; failures and calls of S2 and of U2, on Mecanic; which of our primitives answer the same question, and
# how our kernel does without it where there is none.
TABLE_4 = (
    ("Does_simplex_intersect_dual_support(4)", (21, 84160), (21, 84160), ("side_of_plane",), ""),
    ("Does_simplex_intersect_dual_support(3)", (1021, 168820), (1021, 168820), ("angle",), ""),
    ("Construct_circumcenter(2)", (0, 49225), (0, 94352), (), "midpoints stay implicit"),
    ("Construct_circumcenter(3)", (0, 21886), (0, 145409), ("circumcenter",), ""),
    ("Compare_squared_distance", None, (0, 880154), (), "drivers by angle, side_of_plane"),
    ("Compare_distance", None, (0, 38034), (), "drivers by angle, side_of_plane"),
    ("Compute_squared_distance", (0, 56364), (0, 694958), (), "drivers by angle, side_of_plane"),
    ("Equal(2 points)", (4225, 125337), (8902, 1024888), ("cospherical", "coplanar", "cocircular"), ""),
    ("Orientation(3 vectors)", (0, 110565), (22079, 1385218),
     ("side_of_ray", "ray_at_infinity", "around_start", "along_edge", "nearer_exit"), ""),
    ("Intersect(plane, line)", (0, 24770), (479, 292165), ("crossing",), ""),
    ("Construct_equidistant_line(3)", (0, 24848), (0, 335384), (), "part of crossing"),
    ("Construct_ray", (0, 78), (0, 43219), (), "part of crossing"),
    ("Construct_segment", (0, 81628), (0, 1067714), (), "part of crossing"),
    ("Construct_plane", (0, 24770), (0, 292165), (), "part of crossing"),
)

# name, depth of S2, depth of U2
TABLE_5 = (
    ("Schale", 72, 70),
    ("Mecanic", 60, 153),
    ("BootSki", 39, 615),
    ("Blade", 228, None),
    ("Buddha", 378, None),
    ("Culbuteur", 318, None),
    ("Fish", 492, None),
)
