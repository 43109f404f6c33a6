# What underflow, flushing to zero and subnormal operands read as zero add to the errors, and that nothing overflows.
# Below, e_x bounds how far x computed with them is from x computed with the same relative errors and without them;
# m_x bounds |x|. A result that underflows is off by at most 2^-1022 (by 2^-1075 without flushing), so is an operand
# read as zero. k = 1 + 2^-52 bounds the factor that an operation's rounding puts on errors and magnitudes.

flush = 1b-1022;
k = 1 + 1b-52;

# Coordinate differences, as the filters admit them.
m_arm = 1b150;
e_arm = (flush + flush) * k + flush;

m_product = m_arm * m_arm * k;
e_product = (2 * m_arm * e_arm + e_arm * e_arm) * k + flush;
m_minor = 2 * m_product * k;
e_minor = 2 * e_product * k + flush;                                    # also a signed area
m_term = m_arm * m_minor * k;
e_term = (m_arm * e_minor + m_minor * e_arm + e_arm * e_minor) * k + flush;
m_volume = 3 * m_term * k * k;
e_volume = 3 * e_term * k * k + 2 * flush * k;
m_edge = 3 * m_volume * k * k;                                          # the edge bc: three volumes
e_edge = 3 * e_volume * k * k + 2 * flush * k;

# Comparing hits admits differences up to 2^100.
o_arm = 1b100;
o_product = (2 * o_arm * e_arm + e_arm * e_arm) * k + flush;
o_minor = 2 * o_product * k + flush;
n_minor = 2 * o_arm * o_arm * k * k;
o_term = (o_arm * o_minor + n_minor * e_arm + e_arm * o_minor) * k + flush;
o_volume = 3 * o_term * k * k + 2 * flush * k;
n_volume = 3 * o_arm * n_minor * k * k * k;
o_order = 2 * ((2 * n_volume * o_volume + o_volume * o_volume) * k + flush) * k + flush;
n_order = 2 * n_volume * n_volume * k * k;

# The bound itself is computed from differences that are off by e_arm, and may underflow too.
e_bound = 3 * (m_arm + e_arm) * (m_arm + e_arm) * e_arm;

{ e_edge + e_bound in ? /\ m_edge in ? /\ e_minor + e_bound * 1b-150 in ? /\ o_order in ? /\ n_order in ? }
