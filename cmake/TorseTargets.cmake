# The functions that make our targets out of folders: a new file or folder needs no line here or in CMakeLists.txt.
#   torse_link_headers(BASE FOLDER...)         <build>/include/torse/FOLDER -> BASE/FOLDER
#   torse_options(TARGET)                      warnings, sanitizers and coverage of our own presets
#   torse_library(TARGET FOLDER LINK ...)      a static library of FOLDER/**/*.cpp (header-only while there is none)
#   torse_embed(TARGET FOLDER)                 FOLDER/*.json as text in the library, see studies/built_in.hpp
#   torse_program(TARGET FOLDER NAME N LINK .) the program <build>/N; all but main.cpp is a library, so tests reach it
#   torse_plugin(TARGET FOLDER OF PROGRAM LINK ...)  a module of FOLDER/**/*.cpp beside the program, which opens it at run time; its
#                                              objects are TARGET_objects
#   torse_viewer(SOURCE FILE)                  puts FILE into the object of SOURCE, where FILE is there
#   torse_tests(TARGET FOLDER LINK ...)        one GoogleTest program of FOLDER/**/*.cpp, each test known to ctest
#   torse_fuzz_targets(FOLDER CORPUS LINK ...) one program for each file, on which ctest runs its corpus; with libFuzzer 2 seconds more
#   torse_benchmarks(FOLDER LINK ...)          one program for each file
#   torse_comparison(TARGET FOLDER SOURCE... LINK ...)   a program that only ./x coq builds, with no more of the libraries than it needs
#   torse_peer(BENCHMARK NAME)                 a library to compare with, where it is found

function(torse_link_headers base)
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/include/torse")
  foreach(folder IN LISTS ARGN)
    cmake_path(APPEND PROJECT_SOURCE_DIR "${base}" "${folder}" OUTPUT_VARIABLE origin)
    file(CREATE_LINK "${origin}" "${PROJECT_BINARY_DIR}/include/torse/${folder}" SYMBOLIC)
  endforeach()
endfunction()

function(torse_options target)
  if(TORSE_STRICT)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror)
  endif()
  if(TORSE_SANITIZE)
    set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=all)
    target_compile_options(${target} PRIVATE ${sanitize} -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE ${sanitize})
  endif()
  if(TORSE_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(TORSE_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()

function(torse_library target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" LINK)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$|/fuzz/targets/|/coq/compare/")
  string(REPLACE "torse_" "" name ${target})
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC ${arg_LINK})
    set_target_properties(${target} PROPERTIES ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
    torse_options(${target})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_LINK})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(torse::${name} ALIAS ${target})
endfunction()

function(torse_embed target folder)
  file(GLOB designs CONFIGURE_DEPENDS "${folder}/*.json")
  set(entries "")
  foreach(design IN LISTS designs)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${design}")
    cmake_path(GET design STEM stem)
    file(READ "${design}" text)
    string(APPEND entries "      {\"${stem}\", R\"design(${text})design\"},\n")
  endforeach()
  set(source "${PROJECT_BINARY_DIR}/${target}_built_in.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [=[#include "torse/studies/built_in.hpp"

namespace torse::studies {

const std::vector<BuiltIn>& built_in_designs() {
  static const std::vector<BuiltIn> designs{
@entries@  };
  return designs;
}

}  // namespace torse::studies
]=])
  target_sources(${target} PRIVATE "${source}")
endfunction()

function(torse_program target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" NAME LINK)
  torse_library(${target}_parts ${folder} LINK ${arg_LINK})
  file(GLOB main CONFIGURE_DEPENDS "${folder}/main.cpp")
  if(main)
    add_executable(${target} ${main})
    target_link_libraries(${target} PRIVATE ${target}_parts)
    target_link_options(${target} PRIVATE -Wl,--build-id)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${arg_NAME} RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
    torse_options(${target})
  endif()
endfunction()

function(torse_plugin target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" OF LINK)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  add_library(${target}_objects OBJECT ${sources})
  target_link_libraries(${target}_objects PUBLIC ${arg_LINK})
  set_target_properties(${target}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  torse_options(${target}_objects)
  add_library(${target} MODULE)
  target_link_libraries(${target} PRIVATE ${target}_objects)
  set_target_properties(${target} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
  torse_options(${target})
  add_dependencies(${arg_OF} ${target})
endfunction()

function(torse_viewer source file)
  if(EXISTS "${file}")
    set_source_files_properties("${source}" PROPERTIES COMPILE_DEFINITIONS "TORSE_VIEWER=\"${file}\"" OBJECT_DEPENDS "${file}")
  endif()
endfunction()

function(torse_tests target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" LINK)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(${target} ${sources})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(${target} PRIVATE ${arg_LINK} GTest::gmock GTest::gtest_main rapidcheck rapidcheck_gtest)
  target_compile_definitions(${target} PRIVATE "TORSE_SOURCE_PATH=\"${PROJECT_SOURCE_DIR}\""
                                               "TORSE_PROGRAM_PATH=\"${PROJECT_BINARY_DIR}/torse\"")
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  torse_options(${target})
  string(REGEX REPLACE "^test_" "" label ${target})
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST TEST_PREFIX ${label}: PROPERTIES LABELS ${label} ENVIRONMENT RC_PARAMS=seed=1)
endfunction()

function(torse_fuzz_targets folder corpus)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" LINK)
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM stem)
    set(target fuzz_${stem})
    if(TORSE_FUZZ)
      add_executable(${target} ${source})
      target_link_options(${target} PRIVATE -fsanitize=fuzzer)
    else()
      add_executable(${target} ${source} "${PROJECT_SOURCE_DIR}/fuzz/targets/replay/main.cpp")
    endif()
    target_link_libraries(${target} PRIVATE ${arg_LINK})
    target_compile_definitions(${target} PRIVATE "TORSE_SOURCE_PATH=\"${PROJECT_SOURCE_DIR}\"" "TORSE_BUILD_PATH=\"${PROJECT_BINARY_DIR}\"")
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${stem} RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/targets")
    torse_options(${target})
    if(TARGET torse_cad)
      add_dependencies(${target} torse_cad)
    endif()
    set(seeds "${PROJECT_SOURCE_DIR}/${corpus}/${stem}")
    set(words "${seeds}")
    if(TORSE_FUZZ)
      # New inputs go to the first folder, never into the tree.
      set(scratch "${PROJECT_BINARY_DIR}/tested/${stem}")
      file(MAKE_DIRECTORY "${scratch}")
      set(words -max_total_time=2 -seed=1 -timeout=10 -rss_limit_mb=2048 -close_fd_mask=3 "-artifact_prefix=${scratch}-" "${scratch}" "${seeds}")
    endif()
    add_test(NAME targets:${stem} COMMAND ${target} ${words})
    set_tests_properties(targets:${stem} PROPERTIES LABELS targets)
  endforeach()
endfunction()

function(torse_benchmarks folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" LINK)
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM stem)
    add_executable(bench_${stem} ${source})
    target_link_libraries(bench_${stem} PRIVATE ${arg_LINK})
    set_target_properties(bench_${stem} PROPERTIES OUTPUT_NAME ${stem}
                                                   RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bench")
    torse_options(bench_${stem})
  endforeach()
endfunction()

function(torse_comparison target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" LINK)
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  add_executable(${target} EXCLUDE_FROM_ALL ${sources} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${target} PRIVATE ${arg_LINK})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  torse_options(${target})
endfunction()

# A peer that a benchmark runs beside torse where it is installed; the benchmark says which ones are missing.
function(torse_peer benchmark name)
  find_package(${name})
  if(TARGET ${name}::${name})
    string(TOUPPER "${name}" upper)
    target_link_libraries(bench_${benchmark} PRIVATE ${name}::${name})
    target_compile_definitions(bench_${benchmark} PRIVATE TORSE_BENCH_${upper})
  endif()
endfunction()
