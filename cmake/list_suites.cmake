# Usage: cmake -D program=FILE -D emulator=PROGRAM -D prefix=NAME -D environment=LIST -D listing=FILE
#              -P list_suites.cmake
#
# Writes the ctest tests of a GoogleTest program to a listing: one for each suite, NAME.SUITE. A
# program starts in a fifth of a second, since it loads the libraries of OpenImageIO, so a process
# for each test would take longer than the tests. The emulator is empty unless the program is for
# another architecture.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND "${CMAKE_COMMAND}" -E env ${environment} ${emulator} "${program}" --gtest_list_tests
    OUTPUT_VARIABLE listed RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests fails: ${result}\n${listed}")
endif()

# A suite of which every test was skipped counts as skipped. The end of the output shows that none
# failed.
set(all_skipped "  PASSED  . 0 tests\\.\n([^\n]*  SKIPPED [^\n]*\n)+$")

set(text "")
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." lines "${listed}")
foreach(line IN LISTS lines)
    string(REGEX REPLACE "\n|\\." "" suite "${line}")
    set(name "${prefix}.${suite}")
    string(APPEND text
        "add_test([=[${name}]=] ${emulator} [=[${program}]=] [=[--gtest_filter=${suite}.*]=])\n"
        "set_tests_properties([=[${name}]=] PROPERTIES\n"
        "    SKIP_REGULAR_EXPRESSION [=[${all_skipped}]=] ENVIRONMENT [=[${environment}]=])\n")
endforeach()
file(WRITE "${listing}" "${text}")
