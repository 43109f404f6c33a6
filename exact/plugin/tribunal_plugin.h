/* Bring your own intersection test: what a shared library must export for `tribunal COMMAND --plugin libmine.so`.
 * C99 and C++; needs nothing else of Tribunal. docs/bring-your-own.md is the guide, docs/examples/ has an example.
 *
 * The library exports one function, tribunal_plugin_describe. The program calls it once, copies the strings, and from
 * then on knows the test as a method of that name. A second one, for polygons, is optional, and so is a third, for
 * whole meshes.
 *
 * Promises of the program
 *   - Coordinates are finite: NaN and infinities never reach a plugin.
 *   - Coordinates are exact in the format that the plugin states. A binary32 test may cast them to float without loss.
 *   - The thread rounds to nearest with gradual underflow (no FTZ, no DAZ), whatever flags the library was built with.
 *
 * Promises of the plugin
 *   - ask and ask_batch may be called from several threads at once, in any order, and answer the same query the same.
 *   - ask_batch answers every query as ask does.
 *   - They leave the floating-point environment as they found it, and throw nothing through this interface.
 *   - They return. A plugin runs in the program's own process: if it crashes, the program ends with it. With --isolate
 * it runs in child processes, and what it does in place of returning is a finding. */
#ifndef TRIBUNAL_PLUGIN_H
#define TRIBUNAL_PLUGIN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface; grows when it changes. Libraries built for earlier versions are loaded: what a later
 * version added comes last in each struct, and zero there means what the version before meant. Any other version is
 * refused. */
#define TRIBUNAL_PLUGIN_ABI 3

/* The probe that a query holds. */
enum {
  TRIBUNAL_SEGMENT = 0, /* the closed segment [p, q] */
  TRIBUNAL_RAY = 1      /* the half-line {o + t*d, t >= 0}; d need not have length 1, and may be 0 */
};

/* Answers. UNSUPPORTED: outside the contract; counted, never as an error. */
enum { TRIBUNAL_MISS = 0, TRIBUNAL_HIT = 1, TRIBUNAL_UNSUPPORTED = 2 };

/* The format that the test computes in. A binary32 test is judged on cases that are exact in binary32 only. */
enum { TRIBUNAL_BINARY32 = 32, TRIBUNAL_BINARY64 = 64 };

/* What the test promises of coplanar contacts. CLOSED: a hit where the closed point sets meet. TRANSVERSAL: the same,
 * but a probe in the triangle's plane is a miss (and so is any probe against a triangle without area, and a point in
 * its plane). COPLANAR_UNSPECIFIED (version 2): nothing. It is judged by what it promises, and not where it promises
 * nothing. */
enum { TRIBUNAL_CLOSED = 0, TRIBUNAL_TRANSVERSAL = 1, TRIBUNAL_COPLANAR_UNSPECIFIED = 2 };

/* Which operands the test takes (version 2); a sum of these. A test that takes rays alone says NO_SEGMENTS.
 * NO_DEGENERATE: no triangle without area, and no probe that is a point. */
enum { TRIBUNAL_NO_SEGMENTS = 1, TRIBUNAL_NO_RAYS = 2, TRIBUNAL_NO_DEGENERATE = 4 };

/* What the test makes of a probe that crosses the triangle's plane on its boundary (version 2). CLOSED: a hit. OPEN: a
 * miss. HALF_OPEN: of faces that share an edge or a vertex exactly one is hit, so nothing is promised of one triangle.
 * UNSPECIFIED: nothing. */
enum {
  TRIBUNAL_BOUNDARY_CLOSED = 0,
  TRIBUNAL_BOUNDARY_OPEN = 1,
  TRIBUNAL_BOUNDARY_HALF_OPEN = 2,
  TRIBUNAL_BOUNDARY_UNSPECIFIED = 3
};

/* What the test makes of a contact by an end of the probe alone, t = 0, or t = 1 of a segment (version 2). */
enum { TRIBUNAL_ENDS_CLOSED = 0, TRIBUNAL_ENDS_OPEN = 1, TRIBUNAL_ENDS_UNSPECIFIED = 2 };

/* Which faces the test misses on purpose (version 2). BACK_FACES: triangles whose vertices run clockwise as seen from p
 * or o, where the probe crosses their plane. */
enum { TRIBUNAL_CULLS_NOTHING = 0, TRIBUNAL_CULLS_BACK_FACES = 1 };

/* Which part of the triangle a hit met (version 2). */
enum {
  TRIBUNAL_CONTACT_UNSAID = 0,
  TRIBUNAL_CONTACT_INTERIOR = 1,
  TRIBUNAL_CONTACT_EDGE = 2,
  TRIBUNAL_CONTACT_VERTEX = 3,
  TRIBUNAL_CONTACT_COPLANAR = 4
};

/* Fifteen coordinates: p, q, a, b, c of a segment, or o, d, a, b, c of a ray; x, y, z each. The triangle is the closed
 * conv(a, b, c) and may be degenerate, as the segment may. */
typedef int tribunal_ask(int probe, const double query[15]);

/* n queries with probes of one kind, the i-th at queries + 15*i, each answered in answers[i]. */
typedef void tribunal_ask_batch(int probe, size_t n, const double* queries, int* answers);

/* From which side a hit crosses the triangle, or a face of a mesh (version 3). FRONT: its vertices run counterclockwise
 * as seen from p or o. */
enum { TRIBUNAL_SIDE_UNSAID = 0, TRIBUNAL_SIDE_FRONT = 1, TRIBUNAL_SIDE_BACK = 2 };

/* What is known of a hit beside that it is one (version 2). */
typedef struct tribunal_hit {
  int contact; /* TRIBUNAL_CONTACT_… */
  int has_t;   /* whether t is given */
  double t;    /* the point p + t*(q - p), or o + t*d */
  int side;    /* TRIBUNAL_SIDE_… (version 3) */
} tribunal_hit;

/* A ray with bounds (version 3): o, d, a, b, c as fifteen coordinates, and tmin, tmax. The probe is the set of all
 * o + t*d with tmin <= t <= tmax; 0 <= tmin <= tmax, tmin is finite, tmax may be infinite. Both are exact in the format
 * that the plugin states. */
typedef int tribunal_ask_within(const double query[15], const double bounds[2]);

/* As tribunal_ask, and tells of a hit. `hit` comes zeroed, and is looked at where the answer is TRIBUNAL_HIT. */
typedef int tribunal_tell(int probe, const double query[15], tribunal_hit* hit);

/* A triangle prepared for many probes (version 2): a, b, c as nine coordinates go in, what was made of them comes out;
 * it is asked any number of times, from several threads, and released once. NULL: out of memory. The answers are those
 * of ask. */
typedef void* tribunal_prepare(const double triangle[9]);
typedef int tribunal_ask_prepared(const void* prepared, int probe, const double coordinates[6]);
typedef void tribunal_release(void* prepared);

typedef struct tribunal_plugin {
  int abi;               /* TRIBUNAL_PLUGIN_ABI */
  const char* name;      /* 1 to 32 of a-z A-Z 0-9 . _ -, a letter first; no other method's name */
  const char* contract;  /* version 1: the operands in words. Version 2 says them in `operands`; NULL, or ignored */
  const char* summary;   /* one line for people */
  const char* reference; /* where it was published, or NULL */
  int format;            /* TRIBUNAL_BINARY32 or TRIBUNAL_BINARY64 */
  int convention;        /* TRIBUNAL_CLOSED, TRIBUNAL_TRANSVERSAL or TRIBUNAL_COPLANAR_UNSPECIFIED */
  tribunal_ask* ask;     /* required, but for a library that takes polygons or meshes only */
  tribunal_ask_batch* ask_batch; /* or NULL */

  /* Version 2. */
  int operands;              /* 0, or a sum of TRIBUNAL_NO_SEGMENTS, TRIBUNAL_NO_RAYS, TRIBUNAL_NO_DEGENERATE */
  int boundary;              /* TRIBUNAL_BOUNDARY_… */
  int ends;                  /* TRIBUNAL_ENDS_… */
  int culling;               /* TRIBUNAL_CULLS_… */
  tribunal_tell* tell;       /* or NULL */
  int tells_contact;         /* not 0: tell says the contact */
  int tells_t;               /* not 0: tell gives t of every hit that is one point */
  tribunal_prepare* prepare; /* or NULL; then so are the next two */
  tribunal_ask_prepared* ask_prepared; /* required with prepare */
  tribunal_release* release;           /* or NULL: nothing is to be released */

  /* Version 3. */
  tribunal_ask_within* ask_within; /* or NULL: the test takes no bounds */
  int bounds;     /* TRIBUNAL_ENDS_…: what it makes of a contact at tmin or tmax alone, where a ray has bounds */
  int tells_side; /* not 0: tell says the side */
} tribunal_plugin;

/* Polygons, if the test takes them: a second, optional function, tribunal_plugin_describe_polygons. A library without
 * it has a test of triangles only; one with it may have `ask` NULL in the first description, and then takes polygons
 * only. Name, format and convention are those of the first description; so are the promises above.
 *
 * A polygon is an outer ring and holes, one after the other: ring r has the vertices ends[r-1] (0 for r = 0) up to
 * ends[r], without repeating its first vertex at the end. There is at least one ring, and each has at least one vertex.
 * Rings may be concave, touch, cross, repeat vertices or have no area, and run either way. If all vertices lie in one
 * plane, the polygon is the closed even-odd region of all rings together with all ring edges; otherwise the surface of
 * docs/polygons.md. */
typedef struct tribunal_polygon {
  size_t rings;
  const size_t* ends;     /* rings of them; ends[rings - 1] is the number of vertices */
  const double* vertices; /* x, y, z each */
} tribunal_polygon;

/* Six coordinates of the probe: p, q of a segment, or o, d of a ray. */
typedef int tribunal_ask_polygon(int probe, const double coordinates[6], const tribunal_polygon* polygon);

/* What the test promises of polygons, beside its convention; a sum of these. Where it promises nothing it is not
 * judged. PLANAR_ONLY: nothing of polygons whose vertices do not lie in one plane exactly. NO_BOUNDARY: nothing where
 * the probe meets a ring edge. */
enum { TRIBUNAL_PLANAR_ONLY = 1, TRIBUNAL_NO_BOUNDARY = 2 };

typedef struct tribunal_polygon_plugin {
  int abi;                   /* TRIBUNAL_PLUGIN_ABI, as in tribunal_plugin */
  int restrictions;          /* 0, or a sum of those above */
  tribunal_ask_polygon* ask; /* required */
} tribunal_polygon_plugin;

/* Meshes, if the library has a tree: a third, optional function, tribunal_plugin_describe_meshes. `tribunal leak` puts
 * the whole of it on trial: boxes, pruning, order, bookkeeping. Name, format, boundary and culling are those of the
 * first description, which may have `ask` NULL then. A NULL function is not judged. The promises above hold here too.
 *
 * A face is the closed triangle of three vertices. In the mesh of a trial vertices at one place are one vertex, and
 * faces may have no area. Rays have six coordinates, o and d; d is not 0. */

/* vertices: x, y, z each; corners: three a face, in range. Comes back: what was made of it, which is asked any number
 * of times, from several threads, and released once. NULL: out of memory. The arrays do not outlive the call. */
typedef void* tribunal_mesh_prepare(size_t vertex_count, const double* vertices, size_t face_count,
                                    const size_t* corners);

#define TRIBUNAL_NO_FACE ((size_t)-1)

/* A face that is hit, at o + t*d. t is looked at where the library says that it tells it. */
typedef struct tribunal_mesh_hit {
  size_t face; /* as it stands in `corners`, from 0; or TRIBUNAL_NO_FACE */
  double t;
} tribunal_mesh_hit;

/* The i-th ray is at rays + 6*i. The closest hit; where several faces are hit at one t, any of them. */
typedef void tribunal_mesh_closest(const void* mesh, size_t n, const double* rays, tribunal_mesh_hit* hits);

/* Where normals point (version 3). BY_VERTICES: as (b - a) x (c - a), whichever side is seen. TOWARDS_SOURCE: to the
 * side from which the ray comes. */
enum { TRIBUNAL_NORMAL_BY_VERTICES = 0, TRIBUNAL_NORMAL_TOWARDS_SOURCE = 1 };

/* What is known of the face that is hit (version 3): its normal, of any length, and the side that the ray's source
 * sees. Each is looked at where the library says that it tells it. */
typedef struct tribunal_mesh_normal {
  double normal[3];
  int side; /* TRIBUNAL_SIDE_... */
} tribunal_mesh_normal;

/* As tribunal_mesh_closest, with normals (version 3). The i-th normal is not looked at where no face is hit. */
typedef void tribunal_mesh_closest_normal(const void* mesh, size_t n, const double* rays, tribunal_mesh_hit* hits,
                                          tribunal_mesh_normal* normals);

/* 1 where any face is hit, else 0. */
typedef void tribunal_mesh_any(const void* mesh, size_t n, const double* rays, int* answers);

/* Every face hit, each once, in any order. Returns their number, and writes no more than `capacity` of them; if there
 * are more, it is asked again with more room. */
typedef size_t tribunal_mesh_all(const void* mesh, const double ray[6], size_t capacity, tribunal_mesh_hit* hits);

/* 1 where the source of the ray is inside the closed mesh, else 0. It may be found out along the ray, or otherwise. */
typedef void tribunal_mesh_inside(const void* mesh, size_t n, const double* rays, int* answers);

typedef struct tribunal_mesh_plugin {
  int abi;          /* TRIBUNAL_PLUGIN_ABI, as in tribunal_plugin */
  int tells_t;      /* not 0: closest and all give t */
  int sorted;       /* not 0: all gives the nearest hit first */
  double most_ulps; /* t of the closest hit is within so many units in the last place of binary64; 0: not promised */
  tribunal_mesh_prepare* prepare; /* required */
  tribunal_mesh_closest* closest;
  tribunal_mesh_any* any;
  tribunal_mesh_all* all;
  tribunal_mesh_inside* inside; /* one of these four, or closest_normal, at least */
  tribunal_release* release;    /* or NULL: nothing is to be released */

  /* Version 3. */
  tribunal_mesh_closest_normal* closest_normal; /* or NULL; else it is asked in place of closest */
  int tells_normal;                             /* not 0: closest_normal gives the normal of the face */
  int tells_side;                               /* not 0: it gives the side */
  int normal_sense;                             /* TRIBUNAL_NORMAL_... */
  double most_degrees; /* the angle between a normal and the exact one is no more; 0: not promised, but for the side */
} tribunal_mesh_plugin;

#if defined(__GNUC__)
#define TRIBUNAL_EXPORT __attribute__((visibility("default")))
#else
#define TRIBUNAL_EXPORT
#endif

TRIBUNAL_EXPORT const tribunal_plugin* tribunal_plugin_describe(void);
TRIBUNAL_EXPORT const tribunal_polygon_plugin* tribunal_plugin_describe_polygons(void); /* optional */
TRIBUNAL_EXPORT const tribunal_mesh_plugin* tribunal_plugin_describe_meshes(void);      /* optional */

#ifdef __cplusplus
}
#endif

#endif
