# |computed − exact| of one signed volume det(u, v, w), u = b − a, v = c − a, w = x − a: core/signed_volume.h, det3.
# Every operation is exact up to a factor 1 + δ, |δ| ≤ 2^-52, as in every rounding mode without underflow. The claim is
# homogeneous in each axis, so the largest rounded difference on each axis may be taken as 1.

ux = sub_rel<52>(bx, ax);  uy = sub_rel<52>(by, ay);  uz = sub_rel<52>(bz, az);
vx = sub_rel<52>(cx, ax);  vy = sub_rel<52>(cy, ay);  vz = sub_rel<52>(cz, az);
wx = sub_rel<52>(xx, ax);  wy = sub_rel<52>(xy, ay);  wz = sub_rel<52>(xz, az);

X = sub_rel<52>(mul_rel<52>(vy, wz), mul_rel<52>(vz, wy));
Y = sub_rel<52>(mul_rel<52>(vz, wx), mul_rel<52>(vx, wz));
Z = sub_rel<52>(mul_rel<52>(vx, wy), mul_rel<52>(vy, wx));
volume = add_rel<52>(add_rel<52>(mul_rel<52>(ux, X), mul_rel<52>(uy, Y)), mul_rel<52>(uz, Z));

Ux = bx - ax;  Uy = by - ay;  Uz = bz - az;
Vx = cx - ax;  Vy = cy - ay;  Vz = cz - az;
Wx = xx - ax;  Wy = xy - ay;  Wz = xz - az;
exact = (Ux * (Vy * Wz - Vz * Wy) + Uy * (Vz * Wx - Vx * Wz)) + Uz * (Vx * Wy - Vy * Wx);

{ ux in [-1, 1] /\ uy in [-1, 1] /\ uz in [-1, 1] /\
  vx in [-1, 1] /\ vy in [-1, 1] /\ vz in [-1, 1] /\
  wx in [-1, 1] /\ wy in [-1, 1] /\ wz in [-1, 1]
  -> volume - exact in ? }
