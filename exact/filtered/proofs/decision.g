# What `conclude` of exact/filtered/shared_volumes.h may conclude of volumes as computed: segments, and edges of any
# probe. Signs are turned so that toward >= 0 as computed. `b` is the least that the bound can come to, 169 units: 170
# less what its own four roundings take. The largest arm on each axis is 1, so that no volume exceeds 19.
# Where `tiny` makes the bound larger than 169 units, all thresholds grow in proportion and rounding does not: the goals
# hold with more to spare. What flushing adds to the two sums is below 2^-1020, nothing beside tiny.
# A volume beyond b has the sign it shows (shared_volumes.g); what follows is about computed numbers alone.

b = 169b-52;

# An edge below -3b has another one above b: first ab, then -ac; last, if neither is above b, bc is not below -3b.
bc1 = add_rel<52>(sub_rel<52>(toward1, ab1), ac1);
bc2 = add_rel<52>(sub_rel<52>(toward2, ab2), ac2);
bc3 = add_rel<52>(sub_rel<52>(toward3, ab3), ac3);

# A source above 3b has the target above b; a target below -3b has the source below -b: above it, it is not below -3b.
target4 = add_rel<52>(source4, toward4);
target5 = add_rel<52>(source5, toward5);

{ toward1 in [0, 19] /\ ab1 in [-19, -507b-52] /\ ac1 in [-169b-52, 19] /\
  toward2 in [0, 19] /\ ab2 in [-19, 169b-52] /\ ac2 in [507b-52, 19] /\
  toward3 in [0, 19] /\ ab3 in [-19, 169b-52] /\ ac3 in [-169b-52, 19] /\
  toward4 in [0, 19] /\ source4 in [507b-52, 19] /\
  toward5 in [0, 19] /\ source5 in [-169b-52, 19]
  -> b - bc1 in ? /\ b - bc2 in ? /\ -3 * b - bc3 in ? /\ b - target4 in ? /\ -3 * b - target5 in ? }
