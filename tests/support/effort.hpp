// How many cases a long loop takes: all of them, or an eighth under sanitizers, which are there to
// see each path rather than each case and run ten times slower.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer) && !defined(__SANITIZE_ADDRESS__)
#define __SANITIZE_ADDRESS__ 1  // as g++ says it
#endif
#endif

namespace umbra78::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

constexpr int effort(int cases) { return sanitized ? cases / 8 : cases; }

}  // namespace umbra78::test
