# Compares the system libraries that the CMake package (`named`) and medax.pc (`pc`) give for static
# linking with those that rustc says are needed.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
if(target_dir)
  set(ENV{CARGO_TARGET_DIR} ${target_dir})
endif()
execute_process(
  # The very command of CMakeLists.txt: where it has run, cargo only repeats what rustc said.
  COMMAND cargo rustc --release --locked --lib --no-default-features -- --print native-static-libs
  WORKING_DIRECTORY ${root} ERROR_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT said MATCHES "native-static-libs:([^\n]*)")
  message(FATAL_ERROR "rustc did not say which libraries it needs:\n${said}")
endif()
string(STRIP "${CMAKE_MATCH_1}" needed)

string(REGEX REPLACE "([^ ]+)" "-l\\1" named "${named}")
file(STRINGS ${pc} private REGEX "^Libs.private:")
string(REGEX REPLACE "^Libs.private: *" "" private "${private}")
message("rustc:     ${needed}\nCMake:     ${named}\nmedax.pc:  ${private}")
if(NOT needed STREQUAL named OR NOT needed STREQUAL private)
  message(FATAL_ERROR "they differ; mend native_libs in CMakeLists.txt")
endif()
