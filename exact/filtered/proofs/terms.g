#@ -Eprecision=100
# What rounding does to the filters by terms of exact/filtered/term_filter.h, with or without fused operations (fusing
# only omits roundings). Every operation is exact up to a factor 1 + δ, |δ| ≤ 2^-52, as in every rounding mode without
# underflow; a factor of 1 is one of these, so a term that passes fewer roundings than stand here is covered too.
#
# A sum or difference, rounded, is the sum of its parts, each times the same 1 + δ. So a determinant as computed is the
# sum of its six terms, each times a factor for each operation that it passed; and so are the sum T of the terms'
# magnitudes, and the bound K·T. If one term is never off by more than r times its share of the bound over K, then all
# of them together are not, and any K ≥ r will do. How many roundings a term passes is counted by a test in the lines of
# term_filter.h themselves (TheSourceLinesRoundEachTermAsTermsGSays).
#
# One term of a determinant: its exact arms are taken as 1, which the claim's homogeneity allows.
arms = (1 + a1) * (1 + a2) * (1 + a3);                                  # the product of its rounded arms
value = arms * (((1 + d1) * (1 + d2)) * ((1 + d3) * (1 + d4)) * (1 + d5));
bound = arms * (((1 + e1) * (1 + e2)) * ((1 + e3) * (1 + e4)) * ((1 + e5) * (1 + e6)) * (1 + e7));
volume = (value - 1) / bound;

# One term of n1·d2 − n2·d1, the order of two hits: a product of two such terms, with other factors for each, and of the
# product, the difference and, in the bound, the multiplication by K and the addition of `tiny`.
other_arms = (1 + b1) * (1 + b2) * (1 + b3);
other_value = other_arms * (((1 + f1) * (1 + f2)) * ((1 + f3) * (1 + f4)) * (1 + f5));
product = value * other_value * ((1 + g1) * (1 + g2));
terms = arms * (((1 + e1) * (1 + e2)) * ((1 + e3) * (1 + e4)) * (1 + e5));
other_terms = other_arms * (((1 + h1) * (1 + h2)) * ((1 + h3) * (1 + h4)) * (1 + h5));
order_bound = terms * other_terms * (((1 + i1) * (1 + i2)) * ((1 + i3) * (1 + i4)));
order = (product - 1) / order_bound;

{ a1 in [-1b-52, 1b-52] /\ a2 in [-1b-52, 1b-52] /\ a3 in [-1b-52, 1b-52] /\ b1 in [-1b-52, 1b-52] /\
  b2 in [-1b-52, 1b-52] /\ b3 in [-1b-52, 1b-52] /\ d1 in [-1b-52, 1b-52] /\ d2 in [-1b-52, 1b-52] /\
  d3 in [-1b-52, 1b-52] /\ d4 in [-1b-52, 1b-52] /\ d5 in [-1b-52, 1b-52] /\ e1 in [-1b-52, 1b-52] /\
  e2 in [-1b-52, 1b-52] /\ e3 in [-1b-52, 1b-52] /\ e4 in [-1b-52, 1b-52] /\ e5 in [-1b-52, 1b-52] /\
  e6 in [-1b-52, 1b-52] /\ e7 in [-1b-52, 1b-52] /\ f1 in [-1b-52, 1b-52] /\ f2 in [-1b-52, 1b-52] /\
  f3 in [-1b-52, 1b-52] /\ f4 in [-1b-52, 1b-52] /\ f5 in [-1b-52, 1b-52] /\ g1 in [-1b-52, 1b-52] /\
  g2 in [-1b-52, 1b-52] /\ h1 in [-1b-52, 1b-52] /\ h2 in [-1b-52, 1b-52] /\ h3 in [-1b-52, 1b-52] /\
  h4 in [-1b-52, 1b-52] /\ h5 in [-1b-52, 1b-52] /\ i1 in [-1b-52, 1b-52] /\ i2 in [-1b-52, 1b-52] /\
  i3 in [-1b-52, 1b-52] /\ i4 in [-1b-52, 1b-52]
  -> volume in ? /\ order in ? }
