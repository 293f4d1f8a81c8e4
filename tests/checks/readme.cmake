# The library snippet of README.md is the program tests/consumer/consumer_exact.cpp, which the install test builds and runs,
# and the output under it is what that program prints.
#   source    the project's folder
cmake_minimum_required(VERSION 3.25)
file(READ "${source}/README.md" readme)
file(READ "${source}/tests/consumer/consumer_exact.cpp" snippet)
file(READ "${source}/tests/consumer/consumer_exact.expected" expected)
foreach(part IN ITEMS "```cpp\n${snippet}```" "```text\n${expected}```")
  string(FIND "${readme}" "${part}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "README.md does not hold:\n${part}")
  endif()
endforeach()
