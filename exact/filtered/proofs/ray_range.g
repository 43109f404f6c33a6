# What underflow, flushing to zero and subnormal operands read as zero add where ray_decision.g concludes: it multiplies
# what they do to `toward` by t. Names and model are those of range.g.
# On each axis t*|d| is at most `reach`, two arms; on the longest axis |d| is at least `direction`, so t is at most
# t_max. The parts of the error that grow with |d| are thus bounded by `reach`; those that do not, by t_max.

flush = 1b-1022;
k = 1 + 1b-52;
direction = 1b-150;

m_arm = 1b150;
e_arm = (flush + flush) * k + flush;
m_product = m_arm * m_arm * k;
e_product = (2 * m_arm * e_arm + e_arm * e_arm) * k + flush;
m_minor = 2 * m_product * k;
e_minor = 2 * e_product * k + flush;
e_term = (m_arm * e_minor + m_minor * e_arm + e_arm * e_minor) * k + flush;
e_source = 3 * e_term * k * k + 2 * flush * k;

reach = 2 * (m_arm * k + e_arm);
t_max = reach / direction;
t_term = (e_minor * reach + (m_minor + e_minor) * (t_max * flush)) * k + t_max * flush;
e_toward = 3 * t_term * k * k + 2 * (t_max * flush) * k;

# The bound is computed from arms that are off by e_arm; `reach` and so the 114 units of ray_decision.g as well.
e_bound = 3 * (m_arm + e_arm) * (m_arm + e_arm) * e_arm;

{ e_source + e_toward + e_bound in ? }
