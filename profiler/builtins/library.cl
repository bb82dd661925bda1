// The built-in functions that libclc lacks, gets wrong, or computes in another way than devices do: compiled
// to bitcode with the program, and linked to every kernel before libclc.

#include "profiler/builtins/arctangent.cl"
#include "profiler/builtins/async_copies.cl"
#include "profiler/builtins/conversions.cl"
#include "profiler/builtins/error_function.cl"
#include "profiler/builtins/exponential.cl"
#include "profiler/builtins/gamma.cl"
#include "profiler/builtins/half_conversions.cl"
#include "profiler/builtins/half_functions.cl"
#include "profiler/builtins/half_memory.cl"
#include "profiler/builtins/integer.cl"
#include "profiler/builtins/logarithm.cl"
#include "profiler/builtins/long_atomics.cl"
#include "profiler/builtins/parts.cl"
#include "profiler/builtins/power.cl"
#include "profiler/builtins/remainder.cl"
#include "profiler/builtins/trigonometric.cl"
