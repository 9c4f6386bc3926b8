# Run by CTest: adds an entry for every suite of ${executable}. They run in ${folder}.

# PoCL's kernel cache is not safe between processes, so each executable has its own and its suites take turns.
# PoCL frees little when a process ends, which is not our leak.
set(properties
    WORKING_DIRECTORY "${folder}"
    ENVIRONMENT "POCL_CACHE_DIR=${folder}/pocl_cache\;ASAN_OPTIONS=detect_leaks=0"
    RESOURCE_LOCK "${target}"
    TIMEOUT 600)

execute_process(COMMAND ${executable} --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE status ERROR_QUIET)
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\." suites "\n${listing}")
if(NOT status EQUAL 0 OR NOT suites)
    # Not built or broken: the entry fails and says how.
    add_test(${target} ${executable})
    set_tests_properties(${target} PROPERTIES ${properties})
    return()
endif()

foreach(suite IN LISTS suites)
    string(REGEX REPLACE "[\n.]" "" suite "${suite}")
    add_test(${target}.${suite} ${executable} "--gtest_filter=${suite}.*")
    # Skipped means that every case was: none passed, none failed.
    set_tests_properties(${target}.${suite} PROPERTIES ${properties}
        SKIP_REGULAR_EXPRESSION "\\[  PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\][^\n]*\n?)+$")
endforeach()
