# |computed − exact| of the five volumes of exact/filtered/shared_volumes.h,
# with fused multiply-add, as the vector targets compute them.
# u = b − a, v = c − a, w = source − a, d = target − source (or a ray's direction, exact: the claim covers it).
# Every operation is exact up to a factor 1 + δ, |δ| ≤ 2^-52, as in every rounding mode without underflow. The claim is
# homogeneous in each axis, so the largest rounded difference on each axis may be taken as 1.
# A fused operation rounds once: the exact product stands inside add_rel or sub_rel.
# The last two goals are about computed numbers only: how far rounding spoils target = source + toward and
# ab + bc − ac = toward.

ux = sub_rel<52>(bx, ax);  uy = sub_rel<52>(by, ay);  uz = sub_rel<52>(bz, az);
vx = sub_rel<52>(cx, ax);  vy = sub_rel<52>(cy, ay);  vz = sub_rel<52>(cz, az);
wx = sub_rel<52>(px, ax);  wy = sub_rel<52>(py, ay);  wz = sub_rel<52>(pz, az);
dx = sub_rel<52>(qx, px);  dy = sub_rel<52>(qy, py);  dz = sub_rel<52>(qz, pz);

nx = sub_rel<52>(uy * vz, mul_rel<52>(uz, vy));
ny = sub_rel<52>(uz * vx, mul_rel<52>(ux, vz));
nz = sub_rel<52>(ux * vy, mul_rel<52>(uy, vx));
mx = sub_rel<52>(wy * dz, mul_rel<52>(wz, dy));
my = sub_rel<52>(wz * dx, mul_rel<52>(wx, dz));
mz = sub_rel<52>(wx * dy, mul_rel<52>(wy, dx));
source = add_rel<52>(nz * wz, add_rel<52>(nx * wx, mul_rel<52>(ny, wy)));
toward = add_rel<52>(nz * dz, add_rel<52>(nx * dx, mul_rel<52>(ny, dy)));
ab = add_rel<52>(mz * uz, add_rel<52>(mx * ux, mul_rel<52>(my, uy)));
ac = add_rel<52>(mz * vz, add_rel<52>(mx * vx, mul_rel<52>(my, vy)));
target = add_rel<52>(source, toward);
bc = add_rel<52>(sub_rel<52>(toward, ab), ac);

Ux = bx - ax;  Uy = by - ay;  Uz = bz - az;
Vx = cx - ax;  Vy = cy - ay;  Vz = cz - az;
Wx = px - ax;  Wy = py - ay;  Wz = pz - az;
Dx = qx - px;  Dy = qy - py;  Dz = qz - pz;
Nx = Uy * Vz - Uz * Vy;  Ny = Uz * Vx - Ux * Vz;  Nz = Ux * Vy - Uy * Vx;
Mx = Wy * Dz - Wz * Dy;  My = Wz * Dx - Wx * Dz;  Mz = Wx * Dy - Wy * Dx;
SOURCE = Nz * Wz + (Nx * Wx + Ny * Wy);
TOWARD = Nz * Dz + (Nx * Dx + Ny * Dy);
AB = Mz * Uz + (Mx * Ux + My * Uy);
AC = Mz * Vz + (Mx * Vx + My * Vy);
TARGET = SOURCE + TOWARD;
BC = (TOWARD - AB) + AC;

{ ux in [-1, 1] /\ uy in [-1, 1] /\ uz in [-1, 1] /\
  vx in [-1, 1] /\ vy in [-1, 1] /\ vz in [-1, 1] /\
  wx in [-1, 1] /\ wy in [-1, 1] /\ wz in [-1, 1] /\
  dx in [-1, 1] /\ dy in [-1, 1] /\ dz in [-1, 1]
  -> source - SOURCE in ? /\ toward - TOWARD in ? /\ ab - AB in ? /\ ac - AC in ? /\
     target - TARGET in ? /\ bc - BC in ? /\
     target - (source + toward) in ? /\ bc - ((toward - ab) + ac) in ? }
