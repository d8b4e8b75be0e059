# Compiler options of all targets. Contraction of a*b + c to a fused multiply-add is off, so that
# the scalar and the SIMD runner compute the same products and sums. Without semantic interposition,
# functions of one file are inlined although the code is position independent.
option(BALCONY_WERROR "Treat warnings as errors" OFF)
option(BALCONY_BENCH "Build the benchmarks" ON)
option(BALCONY_PYTHON "Build the module of Python" ON)
option(BALCONY_PCH "Precompile headers from outside" ON)
option(BALCONY_UNITY "Compile the files of a folder in groups" ON)
option(BALCONY_CCACHE "Compile by way of ccache where it is installed" ON)
option(BALCONY_FUZZ "Build the fuzzers, by clang++ and with -fsanitize=fuzzer-no-link" OFF)
set(BALCONY_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize takes them (address,undefined or thread)")

add_library(balcony_options INTERFACE)
target_compile_features(balcony_options INTERFACE cxx_std_20)
target_compile_options(balcony_options INTERFACE -ffp-contract=off -fno-math-errno
    -fno-semantic-interposition
    -Wall -Wextra -Wpedantic -Wconversion -Wnon-virtual-dtor -Wshadow)
if(BALCONY_WERROR)
    target_compile_options(balcony_options INTERFACE -Werror)
endif()
# Fuzzers get past checks that a forger gets past.
if(BALCONY_FUZZ)
    target_compile_definitions(balcony_options INTERFACE FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)
endif()
if(BALCONY_SANITIZE)
    target_compile_options(balcony_options INTERFACE -fsanitize=${BALCONY_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(balcony_options INTERFACE -fsanitize=${BALCONY_SANITIZE})
    # ThreadSanitizer does not see fences; tests/sanitizers/races.txt names what they order.
    if(BALCONY_SANITIZE MATCHES "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(balcony_options INTERFACE -Wno-tsan)
    endif()
endif()

# balcony_optimise_lightly(TARGET): for code that calls others, or that tests run once. It compiles in
# three quarters of the time. At this level, g++ 14 takes for uninitialised what a constructor that
# fails has not reached.
function(balcony_optimise_lightly target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>
        $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

# Lets ccache identify a precompiled header by its text.
find_program(BALCONY_CCACHE_PROGRAM ccache)
mark_as_advanced(BALCONY_CCACHE_PROGRAM)
if(BALCONY_CCACHE AND BALCONY_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros "${BALCONY_CCACHE_PROGRAM}")
endif()
