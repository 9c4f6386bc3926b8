# text_literals(FILE VARIABLE): sets VARIABLE to C++ string literals, one after the other, with FILE's text. A changed file
# runs CMake again.

function(text_literals file variable)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set(literals "")
    # Compilers need not take a literal above 65536 characters, and some stop at 16384.
    string(LENGTH "${text}" length)
    while(length GREATER 12000)
        string(SUBSTRING "${text}" 0 12000 chunk)
        string(FIND "${chunk}" "\n" end REVERSE)
        if(end LESS 0)
            message(FATAL_ERROR "${file} has a line too long to embed")
        endif()
        math(EXPR end "${end} + 1")
        string(SUBSTRING "${text}" 0 ${end} chunk)
        string(SUBSTRING "${text}" ${end} -1 text)
        string(APPEND literals "R\"text(${chunk})text\"\n")
        string(LENGTH "${text}" length)
    endwhile()
    set(${variable} "${literals}R\"text(${text})text\"" PARENT_SCOPE)
endfunction()
