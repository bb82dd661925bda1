#pragma once
// One body, compiled for the vector units that there may be; the loader picks. Its picking runs before the
// sanitizers' run time is up, so not under those.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define WARPGRAIN_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define WARPGRAIN_VECTOR_CLONES
#endif
