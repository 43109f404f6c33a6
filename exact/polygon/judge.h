// Right or wrong: the exact answer to a polygon case, and a method's answer held against it.
#pragma once

#include "exact/harness/judge.h"
#include "exact/polygon/family.h"

namespace tribunal {

/// The exact answer.
struct PolygonTruth {
  Contact contact = Contact::none;
  bool planar = true;
  bool boundary = false;  ///< a ring edge is met: where the contact is edge or vertex, and perhaps where it is coplanar
  bool of_ray = false;    ///< the probe is a ray

  bool hit() const { return contact != Contact::none; }
};

/// The exact answer by ways that must agree: the reference kernel's covering test, prepared and on the fly; for planar
/// polygons, the point where the probe meets the plane, included by a generic ray and by half-open crossings; and the
/// signed crossings of the covering surface, point by point. Ring edges are met by Carathéodory's theorem, and off the
/// plane the contact says the same of them.
/// Fails with Exit::oracles_contradict where two differ; there is no majority.
PolygonTruth exact_truth(const PolygonQuery& query);

/// exact_truth, which must also be what the trial's construction proves.
PolygonTruth truth_of(const PolygonTrial& trial);

/// Whether the method promises anything of a case with this exact answer.
bool is_promised(const PolygonPromise& promise, const PolygonTruth& truth);

/// The answer, or `unsupported` where the method promises none: an inexact method cannot tell by itself whether a
/// polygon is planar, or a probe meets its boundary.
PolygonAnswer within_contract(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer);
inline Answer within_contract(const Method&, const Truth&, const Answer& answer) { return answer; }

/// By the method's own convention and promise: coplanar contacts are misses to a transversal method; probes that meet a
/// ring edge and polygons that are not planar are not judged where the method promises nothing of them. A fault is
/// wrong everywhere: to answer is promised of every query.
Judgement judge(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer);

}  // namespace tribunal
