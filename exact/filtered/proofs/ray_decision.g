# Why `conclude` of exact/filtered/shared_volumes.h may call a ray a miss by its source alone, though `toward` may show the
# wrong sign. Names, rounding and scaling are those of shared_volumes.g; signs are turned so that toward >= 0 as
# computed, and source is above it.
#
# Say that the ray met the triangle off its own plane all the same. Then SOURCE + t*TOWARD = 0 for some t > 0, and t*d
# leads from the source to a point of the triangle; so on each axis |t*d| <= |W| + max(|U|, |V|) <= 2/(1 - 2^-52), the
# largest rounded arm being 1. For given relative roundings the computed toward is linear in d. So let e = t*d stand
# for d: what is computed then is t times toward, which has its sign, and TOWARD is t times the exact one.
# The script shows that source then is below the bound of a hit: far below the 3*169 units that `conclude` asks for.
# Both ways of computing: each operation rounded, and fused.

ux = sub_rel<52>(bx, ax);  uy = sub_rel<52>(by, ay);  uz = sub_rel<52>(bz, az);
vx = sub_rel<52>(cx, ax);  vy = sub_rel<52>(cy, ay);  vz = sub_rel<52>(cz, az);
wx = sub_rel<52>(px, ax);  wy = sub_rel<52>(py, ay);  wz = sub_rel<52>(pz, az);

nx = sub_rel<52>(mul_rel<52>(uy, vz), mul_rel<52>(uz, vy));
ny = sub_rel<52>(mul_rel<52>(uz, vx), mul_rel<52>(ux, vz));
nz = sub_rel<52>(mul_rel<52>(ux, vy), mul_rel<52>(uy, vx));
source = add_rel<52>(add_rel<52>(mul_rel<52>(nx, wx), mul_rel<52>(ny, wy)), mul_rel<52>(nz, wz));
toward = add_rel<52>(add_rel<52>(mul_rel<52>(nx, ex), mul_rel<52>(ny, ey)), mul_rel<52>(nz, ez));

fx = sub_rel<52>(uy * vz, mul_rel<52>(uz, vy));
fy = sub_rel<52>(uz * vx, mul_rel<52>(ux, vz));
fz = sub_rel<52>(ux * vy, mul_rel<52>(uy, vx));
source_fused = add_rel<52>(fz * wz, add_rel<52>(fx * wx, mul_rel<52>(fy, wy)));
toward_fused = add_rel<52>(fz * ez, add_rel<52>(fx * ex, mul_rel<52>(fy, ey)));

Ux = bx - ax;  Uy = by - ay;  Uz = bz - az;
Vx = cx - ax;  Vy = cy - ay;  Vz = cz - az;
Wx = px - ax;  Wy = py - ay;  Wz = pz - az;
Nx = Uy * Vz - Uz * Vy;  Ny = Uz * Vx - Ux * Vz;  Nz = Ux * Vy - Uy * Vx;
SOURCE = (Nx * Wx + Ny * Wy) + Nz * Wz;
TOWARD = (Nx * ex + Ny * ey) + Nz * ez;
HEIGHT = SOURCE + TOWARD;
SOURCE_FUSED = Nz * Wz + (Nx * Wx + Ny * Wy);   # the same sums, in the order of the fused operations
TOWARD_FUSED = Nz * ez + (Nx * ex + Ny * ey);
HEIGHT_FUSED = SOURCE_FUSED + TOWARD_FUSED;

source_error = source - SOURCE;
toward_error = toward - TOWARD;
source_error_fused = source_fused - SOURCE_FUSED;
toward_error_fused = toward_fused - TOWARD_FUSED;

{ ux in [-1, 1] /\ uy in [-1, 1] /\ uz in [-1, 1] /\
  vx in [-1, 1] /\ vy in [-1, 1] /\ vz in [-1, 1] /\
  wx in [-1, 1] /\ wy in [-1, 1] /\ wz in [-1, 1] /\
  ex in [-2.000000000000001, 2.000000000000001] /\
  ey in [-2.000000000000001, 2.000000000000001] /\
  ez in [-2.000000000000001, 2.000000000000001] /\
  HEIGHT in [0, 0] /\ HEIGHT_FUSED in [0, 0] /\ toward in [0, 19] /\ toward_fused in [0, 19]
  -> source in ? /\ source_fused in ? }

source -> ((source_error + HEIGHT) + toward_error) - toward;
source_fused -> ((source_error_fused + HEIGHT_FUSED) + toward_error_fused) - toward_fused;
