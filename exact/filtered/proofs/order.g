# |computed − exact| of n1·d2 − n2·d1, the order of two hits along a ray: core/kernel.h, order_of_hits.
# The four volumes are known from volume.g: off by at most 46 units (and a little of the second order: 1.0215e-14) where the largest
# difference on each axis is 1; their exact values are then at most 6, and a little for the differences' rounding.

difference = sub_rel<52>(mul_rel<52>(n1, d2), mul_rel<52>(n2, d1));
exact = N1 * D2 - N2 * D1;

{ n1 - N1 in [-1.0215e-14, 1.0215e-14] /\ d1 - D1 in [-1.0215e-14, 1.0215e-14] /\
  n2 - N2 in [-1.0215e-14, 1.0215e-14] /\ d2 - D2 in [-1.0215e-14, 1.0215e-14] /\
  N1 in [-6.0001, 6.0001] /\ D1 in [-6.0001, 6.0001] /\ N2 in [-6.0001, 6.0001] /\ D2 in [-6.0001, 6.0001]
  -> difference - exact in ? }
