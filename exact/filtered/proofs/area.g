# |computed − exact| of twice a signed area, f.u·g.v − f.v·g.u with f = b − a, g = x − a: core/signed_volume.h.
# Every operation is exact up to a factor 1 + δ, |δ| ≤ 2^-52, as in every rounding mode without underflow. The claim is
# homogeneous in each axis, so the largest rounded difference on each axis may be taken as 1.

fu = sub_rel<52>(bu, au);  fv = sub_rel<52>(bv, av);
gu = sub_rel<52>(xu, au);  gv = sub_rel<52>(xv, av);
area = sub_rel<52>(mul_rel<52>(fu, gv), mul_rel<52>(fv, gu));

exact = (bu - au) * (xv - av) - (bv - av) * (xu - au);

{ fu in [-1, 1] /\ fv in [-1, 1] /\ gu in [-1, 1] /\ gv in [-1, 1] -> area - exact in ? }
