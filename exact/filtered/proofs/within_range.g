# What underflow, flushing to zero and subnormal operands read as zero take from the filter of exact/filtered/within_filter.h,
# and that nothing overflows. Names as in terms_range.g. Arms are below 2^150; t is 0, or from 2^-150 to 2^150 like an arm, so it is
# itself never flushed. Each volume loses e_volume; t times that, what the product underflows by, and the sum's own
# flushing are added; the sum of the terms' magnitudes loses no more; the bound loses K times that and its own.

flush = 1b-1022;
k = 1 + 1b-52;
e_arm = (flush + flush) * k + flush;
m_arm = 1b150;
m_minor = 2 * m_arm * m_arm * k * k;
m_volume = 3 * m_arm * m_minor * k * k * k;
e_product = (2 * m_arm * e_arm + e_arm * e_arm) * k + flush;
e_minor = 2 * e_product * k + flush;
e_term = (m_arm * e_minor + m_minor * e_arm + e_arm * e_minor) * k + flush;
e_volume = 3 * e_term * k * k + 2 * flush * k;

m_side = (m_volume + m_arm * m_volume * k) * k;
e_side = (e_volume + (m_arm * e_volume * k + flush)) * k + flush;
e_side_filter = e_side + ((11b-52 * e_side) * k + flush) * k + flush;

{ e_side_filter in ? /\ m_side in ? }
