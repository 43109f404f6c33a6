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
  At at = At::unsaid;     ///< which part of the probe is in contact, where the reference says so

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

/// What contracts can turn on in a case with this exact answer.
Facts facts_of(const PolygonTruth& truth);

/// The answer, or `unsupported` where the method promises none: an inexact method cannot tell by itself whether a
/// polygon is planar, or a probe meets its boundary.
PolygonAnswer within_contract(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer);

/// By the method's own contract, as triangles are: probes that meet a ring edge and polygons that are not planar are
/// not judged where it owes nothing to them.
Judgement judge(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer);

}  // namespace tribunal
