#pragma once

// SFW_FUNCTION_VERSIONS before a function asks for two versions of it: one for every processor, and
// one for processors with AVX2, which calculate with four numbers at once. The loader takes the
// right one. Both give the same bytes, as neither joins a product and a sum into one rounding.
//
// The sanitizers' start-up does not stand functions that the loader chooses.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(SFW_ONE_VERSION)
#define SFW_FUNCTION_VERSIONS __attribute__((target_clones("avx2", "default")))
#else
#define SFW_FUNCTION_VERSIONS
#endif
