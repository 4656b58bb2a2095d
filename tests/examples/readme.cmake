# The C block of `readme` is the file `example`.
file(READ ${readme} text)
file(READ ${example} source)
string(FIND "${text}" "```c\n${source}```\n" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the C example in ${readme} is not ${example}")
endif()
message("the README shows ${example}")
