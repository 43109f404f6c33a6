# What underflow, flushing to zero and subnormal operands read as zero take from the filters by terms, and that nothing
# overflows: as in range.g, whose names these are. The sum T of the terms' magnitudes is computed by as many operations
# as the determinant, of numbers of the same magnitude, so it loses no more; the bound K·T + tiny loses K times that,
# and what flushing takes from its own two operations.

flush = 1b-1022;
k = 1 + 1b-52;
e_arm = (flush + flush) * k + flush;

# Arms below 2^150.
m_arm = 1b150;
m_minor = 2 * m_arm * m_arm * k * k;
m_volume = 3 * m_arm * m_minor * k * k * k;
e_product = (2 * m_arm * e_arm + e_arm * e_arm) * k + flush;
e_minor = 2 * e_product * k + flush;
e_term = (m_arm * e_minor + m_minor * e_arm + e_arm * e_minor) * k + flush;
e_volume = 3 * e_term * k * k + 2 * flush * k;
e_terms_filter = e_volume + ((9b-52 * e_volume) * k + flush) * k + flush;

# Comparing hits admits arms up to 2^100.
o_arm = 1b100;
n_minor = 2 * o_arm * o_arm * k * k;
n_volume = 3 * o_arm * n_minor * k * k * k;
n_order = 2 * n_volume * n_volume * k * k;
o_product = (2 * o_arm * e_arm + e_arm * e_arm) * k + flush;
o_minor = 2 * o_product * k + flush;
o_term = (o_arm * o_minor + n_minor * e_arm + e_arm * o_minor) * k + flush;
o_volume = 3 * o_term * k * k + 2 * flush * k;
o_order = 2 * ((2 * n_volume * o_volume + o_volume * o_volume) * k + flush) * k + flush;
o_terms_filter = o_order + ((21b-52 * o_order) * k + flush) * k + flush;

{ e_terms_filter in ? /\ m_volume in ? /\ o_terms_filter in ? /\ n_order in ? }
