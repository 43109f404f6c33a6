# |computed − exact| of what exact/filtered/plane_crossing.h computes, without fused operations (fusing only omits
# roundings). Every operation is exact up to a factor 1 + δ, |δ| ≤ 2^-52, as in every rounding mode without underflow.
# The claims are homogeneous: in the normal (a product of two arms of its triangle is at most 1/8), in the largest
# coordinate of each end of the probe, and in the extent of the polygon's vertices, so these are taken as 1.

# A height: the normal is known from area.g, 8 units times 1/8, and a little of the second order; each of its
# components is the difference of two products of at most 1/8.
wx = sub_rel<52>(px, ax);  wy = sub_rel<52>(py, ay);  wz = sub_rel<52>(pz, az);
height = add_rel<52>(add_rel<52>(mul_rel<52>(nx, wx), mul_rel<52>(ny, wy)), mul_rel<52>(nz, wz));
HEIGHT = (NX * (px - ax) + NY * (py - ay)) + NZ * (pz - az);

# The point, one coordinate: s·z − t·w, heights s and t known from above: at most 3/4, off by 5.75 units.
zu = sub_rel<52>(qu, au);  wu = sub_rel<52>(pu, au);
point = sub_rel<52>(mul_rel<52>(s, zu), mul_rel<52>(t, wu));
POINT = S * (qu - au) - T * (pu - au);

# A vertex times den. On a segment den = s1 − t1, where the largest coordinates of both ends together are taken as 1;
# on a ray den = −t1, which is the same with s1 = 0 and no rounding.
fu = sub_rel<52>(vu, au);
den = sub_rel<52>(s1, t1);
reached = mul_rel<52>(fu, den);
REACHED = (vu - au) * (S1 - T1);

# The side of an edge. Where the range G = |w||z| + extent (|w| + |z|) is taken as 1, `ahead` is at most 1.5 (its parts:
# 3/4 of extent (|w| + |z|), 3/2 of |w||z|), and off by 18 units: crossing_bounds.vertex.
eu = sub_rel<52>(bu, fau);  ev = sub_rel<52>(bv, fav);
side = sub_rel<52>(mul_rel<52>(ev, ahead_u), mul_rel<52>(eu, ahead_v));
SIDE = (BV - FAV) * AHEAD_U - (BU - FAU) * AHEAD_V;

{ nx in [-0.25001, 0.25001] /\ ny in [-0.25001, 0.25001] /\ nz in [-0.25001, 0.25001] /\
  nx - NX in [-2.2206e-16, 2.2206e-16] /\ ny - NY in [-2.2206e-16, 2.2206e-16] /\
  nz - NZ in [-2.2206e-16, 2.2206e-16] /\
  wx in [-1, 1] /\ wy in [-1, 1] /\ wz in [-1, 1] /\
  zu in [-1, 1] /\ wu in [-1, 1] /\ fu in [-1, 1] /\
  s in [-0.75004, 0.75004] /\ t in [-0.75004, 0.75004] /\
  s - S in [-1.277e-15, 1.277e-15] /\ t - T in [-1.277e-15, 1.277e-15] /\
  s1 - t1 in [-0.75004, 0.75004] /\ (s1 - t1) - (S1 - T1) in [-1.277e-15, 1.277e-15] /\
  fau in [-1, 1] /\ fav in [-1, 1] /\ bu in [-1, 1] /\ bv in [-1, 1] /\
  fau - FAU in [-1b-52, 1b-52] /\ fav - FAV in [-1b-52, 1b-52] /\
  bu - BU in [-1b-52, 1b-52] /\ bv - BV in [-1b-52, 1b-52] /\
  ahead_u in [-1.5001, 1.5001] /\ ahead_v in [-1.5001, 1.5001] /\
  ahead_u - AHEAD_U in [-18b-52, 18b-52] /\ ahead_v - AHEAD_V in [-18b-52, 18b-52]
  -> height - HEIGHT in ? /\ point - POINT in ? /\ reached - REACHED in ? /\ side - SIDE in ? }
