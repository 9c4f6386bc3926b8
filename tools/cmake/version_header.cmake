# write_version_header(): <build>/generated/brandung_version.h with the version and what git says of the source when
# CMake runs: the commit, and "dirty" where files differ from it.

function(write_version_header)
    execute_process(
        COMMAND git -C ${PROJECT_SOURCE_DIR} describe --always --tags --dirty
        OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT description)
        set(description unknown)
    endif()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/brandung_version.h CONTENT
"#pragma once
#define BRANDUNG_VERSION \"@PROJECT_VERSION@\"
#define BRANDUNG_GIT \"@description@\"
" @ONLY)

    # Every commit and checkout adds a line to this log, so the next build sees it.
    execute_process(
        COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --path-format=absolute --git-path logs/HEAD
        OUTPUT_VARIABLE log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(EXISTS "${log}")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
    endif()
endfunction()
