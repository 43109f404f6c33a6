# What underflow, flushing to zero and subnormal operands read as zero add to the errors of plane_crossing.h, and that
# nothing overflows. As in range.g: e_x bounds how far x is from x computed with relative errors only, m_x bounds |x|.
# Goals named r_x are relative to what the bound is multiplied by; the constants leave room for 1/8 of a unit, 2^-55.

flush = 1b-1022;
k = 1 + 1b-52;

# The normal: arms up to 2^150, the largest product of two of them at least 2^-200, scaled up by at most 2^197.
m_arm = 1b150;
e_arm = (flush + flush) * k + flush;
e_minor = 2 * ((2 * m_arm * e_arm + e_arm * e_arm) * k + flush) * k + flush;
e_normal = e_minor * 1b197 + flush;
r_normal = 3 * e_normal * k * k * k;                                    # of the largest coordinate of the arm

# A height: arms of any length times a normal of at most 1/4 on each axis, and a little.
m_normal = 0.25 * k * k * k;
m_height = 3 * m_normal * 1b1024 * k * k * k;                           # below 2^1024: no overflow
e_height = 3 * (m_normal * e_arm + flush) * k * k * k + 2 * flush;      # against tiny

# Heights are certain beyond 2^-800, and an arm is no shorter than the height that it gives: what was flushed there is
# relative from here on. The extent is at least 2^-402, as the normal's longest axis is certain.
r_height = e_height * 1b800;
r_arm = e_arm * 1b801;
r_vertex = e_arm * 1b402;

# Where the range is below 2^850 and the extent, as all arms, below 2^150; products are flushed three times.
m_ahead = 1.5 * 1b850 * k * k * k * k;
e_ahead = 4 * flush * k * k;                                            # against tiny
m_side = 4 * m_arm * m_ahead * k * k;
e_side = (4 * m_arm * (e_ahead + e_arm) * k + 2 * flush) * k + flush; # against tiny

{ r_normal in ? /\ m_height in ? /\ e_height in ? /\ r_height in ? /\ r_arm in ? /\ r_vertex in ? /\
  e_ahead in ? /\ m_side in ? /\ e_side in ? }
