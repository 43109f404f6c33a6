#@ -Eprecision=100
# What rounding does to the side of a point o + t·d in exact/filtered/within_filter.h: V(o) + t·V(d). As in terms.g, whose
# names and argument these are, a term passes so many factors 1 + δ, |δ| ≤ 2^-52: those of its volume, then the product
# with t (which those of V(o) do not pass) and the sum; in the bound also the multiplication by K and the addition of
# `tiny`. A test counts them in the source lines.

arms = (1 + a1) * (1 + a2) * (1 + a3);
value = arms * (((1 + d1) * (1 + d2)) * ((1 + d3) * (1 + d4)) * (1 + d5)) * ((1 + g1) * (1 + g2));
terms = arms * (((1 + e1) * (1 + e2)) * ((1 + e3) * (1 + e4)) * (1 + e5));
bound = terms * (((1 + h1) * (1 + h2)) * ((1 + h3) * (1 + h4)));
side = (value - 1) / bound;

{ a1 in [-1b-52, 1b-52] /\ a2 in [-1b-52, 1b-52] /\ a3 in [-1b-52, 1b-52] /\
  d1 in [-1b-52, 1b-52] /\ d2 in [-1b-52, 1b-52] /\ d3 in [-1b-52, 1b-52] /\ d4 in [-1b-52, 1b-52] /\
  d5 in [-1b-52, 1b-52] /\ e1 in [-1b-52, 1b-52] /\ e2 in [-1b-52, 1b-52] /\ e3 in [-1b-52, 1b-52] /\
  e4 in [-1b-52, 1b-52] /\ e5 in [-1b-52, 1b-52] /\ g1 in [-1b-52, 1b-52] /\ g2 in [-1b-52, 1b-52] /\
  h1 in [-1b-52, 1b-52] /\ h2 in [-1b-52, 1b-52] /\ h3 in [-1b-52, 1b-52] /\ h4 in [-1b-52, 1b-52]
  -> side in ? }
