# Runs an example and compares what it says, and the digest of what it writes, with `expected`.
#   -D example=NAME -D program=FILE -D arguments="IN ..." -D out=FILE -D digest=PROGRAM -D expected=FILE
file(STRINGS ${expected} line REGEX "^${example} ")
if(NOT line MATCHES "^[^ ]+ ([0-9a-f]+) (.*)$")
  message(FATAL_ERROR "${expected} has no line for ${example}")
endif()
set(hash ${CMAKE_MATCH_1})
set(counts ${CMAKE_MATCH_2})
separate_arguments(arguments)
execute_process(COMMAND ${program} ${arguments} ${out}
  OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
message("${said}")
if(NOT status EQUAL 0 OR NOT said STREQUAL counts)
  message(FATAL_ERROR "${program} failed or counted otherwise than '${counts}': ${complaint}")
endif()
execute_process(COMMAND ${digest} ${out} OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT found STREQUAL hash)
  message(FATAL_ERROR "${out} has the digest ${found}, not ${hash}")
endif()
# Without arguments it says how it is called.
execute_process(COMMAND ${program} OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT complaint MATCHES "^usage: ${example} ")
  message(FATAL_ERROR "${program} without arguments: ${status}, ${said}${complaint}")
endif()
# So it does where a limit is no number.
if(example STREQUAL wall_thickness)
  list(GET arguments 0 part)
  execute_process(COMMAND ${program} ${part} abc no_limit.ply
    OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE status)
  if(NOT status EQUAL 2 OR NOT said STREQUAL "" OR NOT complaint STREQUAL "usage: wall_thickness PART LIMIT MESH\n")
    message(FATAL_ERROR "${program} with the limit abc: ${status}, ${said}${complaint}")
  endif()
endif()
