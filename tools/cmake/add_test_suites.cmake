# add_test_suites(TARGET): one CTest entry per suite of a GoogleTest executable, found when CTest starts.
# A process per case would spend most of its time starting OpenCL; a process per executable says too little when it fails.

function(add_test_suites target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_run)
    file(GENERATE OUTPUT ${folder}/suites.cmake CONTENT
"set(target \"${target}\")
set(executable \"$<TARGET_FILE:${target}>\")
set(folder \"${folder}\")
include(\"${PROJECT_SOURCE_DIR}/tools/cmake/list_test_suites.cmake\")
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${folder}/suites.cmake)
endfunction()
