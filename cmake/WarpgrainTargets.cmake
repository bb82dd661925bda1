# warpgrain_library(NAME [UNITY n [APART regex n]] [LINK target...]): a static library of every .cpp below the current folder.
# Sources are found, not listed, so that a new file needs no second place to be named in.

add_library(warpgrain_options INTERFACE)
target_compile_options(warpgrain_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Werror
  # The reference must give the same bits whatever the compiler's taste for fused multiply-add.
  -ffp-contract=off)
if(WARPGRAIN_SANITIZE)
  target_compile_options(warpgrain_options INTERFACE -fsanitize=${WARPGRAIN_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all
    # GCC 12 sees one in std::regex when it is instrumented.
    -Wno-maybe-uninitialized)
  target_link_options(warpgrain_options INTERFACE -fsanitize=${WARPGRAIN_SANITIZE})
endif()

# Most of a clean build is reading headers, so where it pays several sources go to the compiler as one
# (-DCMAKE_UNITY_BUILD=OFF for work on single files). Names in the unnamed namespaces of a group therefore differ. A
# source's group follows from its name alone, so that a new file changes no other's. Sources that match APART have
# groups of their own: headers that only they see are read less often.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
endif()
function(warpgrain_unity target n_groups)  # [regex n] of the sources apart
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  if(NOT n_groups)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(name "${source}" NAME)
    string(MD5 hash "${name}")
    string(SUBSTRING "${hash}" 0 6 digits)
    if(ARGC GREATER 2 AND "${source}" MATCHES "${ARGV2}")
      math(EXPR group "0x${digits} % ${ARGV3}")
      string(PREPEND group "apart_")
    else()
      math(EXPR group "0x${digits} % ${n_groups}")
    endif()
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
endfunction()

function(warpgrain_library name)
  cmake_parse_arguments(ARG "" "UNITY" "APART;LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/program/")  # main functions are not library code
  if(sources)
    add_library(${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${name} PRIVATE warpgrain_options)
    warpgrain_unity(${name} "${ARG_UNITY}" ${ARG_APART})
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} ${scope} "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} ${scope} ${ARG_LINK})
endfunction()

# warpgrain_embed(TARGET HEADER H NAMESPACE N TYPE T FUNCTION F FILES file...): adds a generated source to the target that
# defines `std::span<const T> F()`, declared by H in N: a row {path, text} a file, paths relative to the current folder.
# So an installed warpgrain needs no source tree.
function(warpgrain_embed target)
  cmake_parse_arguments(ARG "" "HEADER;NAMESPACE;TYPE;FUNCTION" "FILES" ${ARGN})
  set(script "${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake")
  set(out "${CMAKE_CURRENT_BINARY_DIR}/${ARG_FUNCTION}.cpp")
  list(TRANSFORM ARG_FILES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE paths)
  add_custom_command(OUTPUT "${out}"
    COMMAND "${CMAKE_COMMAND}" "-DROOT=${CMAKE_CURRENT_SOURCE_DIR}" "-DFILES=${ARG_FILES}" "-DOUT=${out}"
      "-DHEADER=${ARG_HEADER}" "-DNAMESPACE=${ARG_NAMESPACE}" "-DTYPE=${ARG_TYPE}" "-DFUNCTION=${ARG_FUNCTION}"
      -P "${script}"
    DEPENDS ${paths} "${script}" VERBATIM)
  target_sources(${target} PRIVATE "${out}")
endfunction()

# warpgrain_embed_bytes(TARGET HEADER H NAMESPACE N FUNCTION F FILE path): the same for one file of any bytes, as
# `std::string_view F()`.
function(warpgrain_embed_bytes target)
  cmake_parse_arguments(ARG "" "HEADER;NAMESPACE;FUNCTION;FILE" "" ${ARGN})
  set(script "${PROJECT_SOURCE_DIR}/cmake/EmbedBytes.cmake")
  set(out "${CMAKE_CURRENT_BINARY_DIR}/${ARG_FUNCTION}.cpp")
  add_custom_command(OUTPUT "${out}"
    COMMAND "${CMAKE_COMMAND}" "-DFILE=${ARG_FILE}" "-DOUT=${out}" "-DHEADER=${ARG_HEADER}" "-DNAMESPACE=${ARG_NAMESPACE}"
      "-DFUNCTION=${ARG_FUNCTION}" -P "${script}"
    DEPENDS "${ARG_FILE}" "${script}" VERBATIM)
  target_sources(${target} PRIVATE "${out}")
endfunction()

# warpgrain_test(FOLDER [UNITY n] [LINK target...]): one test program of tests/FOLDER/*.cpp, its cases known to CTest. Of a folder
# A/B the program is test_A_B.
function(warpgrain_test folder)
  cmake_parse_arguments(ARG "" "UNITY" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp")
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" program "test_${folder}")
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE warpgrain_options GTest::gtest_main GTest::gmock warpgrain_test_paths ${ARG_LINK})
  warpgrain_unity(${program} "${ARG_UNITY}")
  # Tests spend their time in the libraries, builds theirs in the tests.
  target_compile_options(${program} PRIVATE $<$<CONFIG:Release>:-O0>)
  gtest_discover_tests(${program} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
