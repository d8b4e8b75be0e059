// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Embree 3 or 4, whichever CMake found: BALCONY_EMBREE is its major version. Queries are declared
// differently in the two and have names of their own here; all else that is used is the same.

#include <cstddef>
#include <span>

#if BALCONY_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include "shading/geometry/ray.hpp"

namespace balcony::render::embree {

#if BALCONY_EMBREE == 3

/// What a query passes to the filter functions of geometries.
struct QueryContext : RTCIntersectContext {
    QueryContext() { rtcInitIntersectContext(this); }
};

inline void intersect(RTCScene scene, RTCRayHit& ray) {
    QueryContext context;
    rtcIntersect1(scene, &context, &ray);
}

/// One or two packets of similar directions. A stream of two costs less than each by itself.
inline void intersect(RTCScene scene, std::span<Packet> pair) {
    QueryContext context;
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersectNM(scene, &context, reinterpret_cast<RTCRayHitN*>(pair.data()), Packet::size,
                   static_cast<unsigned>(pair.size()), sizeof(Packet));
}

inline void occluded(RTCScene scene, QueryContext& context, RTCRay& ray) {
    rtcOccluded1(scene, &context, &ray);
}

inline void occluded(RTCScene scene, QueryContext& context, const int* valid, RTCRay16* rays) {
    rtcOccluded16(valid, scene, &context, rays);
}

#else

struct QueryContext : RTCRayQueryContext {
    QueryContext() { rtcInitRayQueryContext(this); }
};

inline void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray); }

// Embree 4 has no streams.
inline void intersect(RTCScene scene, std::span<Packet> pair) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    for (Packet& packet : pair) {
        rtcIntersect16(packet.valid.data(), scene, reinterpret_cast<RTCRayHit16*>(&packet),
                       &arguments);
    }
}

inline RTCOccludedArguments arguments_of(QueryContext& context) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    return arguments;
}

inline void occluded(RTCScene scene, QueryContext& context, RTCRay& ray) {
    RTCOccludedArguments arguments = arguments_of(context);
    rtcOccluded1(scene, &ray, &arguments);
}

inline void occluded(RTCScene scene, QueryContext& context, const int* valid, RTCRay16* rays) {
    RTCOccludedArguments arguments = arguments_of(context);
    rtcOccluded16(valid, scene, rays, &arguments);
}

#endif

}  // namespace balcony::render::embree
