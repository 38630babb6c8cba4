# Headers parsed once for many files, one library each: rooms reuse those of the one that SPEAKS names.
# GCC takes a precompiled header only for the same optimisation, so each kind of room has its own.
function(toile_precompiled NAME HEADER)
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled/${NAME}.cpp "")
  add_library(${NAME} STATIC ${CMAKE_BINARY_DIR}/precompiled/${NAME}.cpp)
  target_include_directories(${NAME} PRIVATE ${CMAKE_SOURCE_DIR})
  target_compile_options(${NAME} PRIVATE ${ARGN})
  target_precompile_headers(${NAME} PRIVATE ${CMAKE_SOURCE_DIR}/cmake/precompiled/${HEADER})
endfunction()

# The sources of a target are compiled some at a time, each such batch as one: most of a source's time goes to the
# standard library's templates, which a batch reads and instantiates once. Batches are alike in size, so that no core
# waits for a last long one. Names without linkage must differ within a target. CMAKE_UNITY_BUILD=OFF compiles each alone.
set(TOILE_BATCH 10 CACHE STRING "Sources that are compiled as one, at most")
function(toile_batches TARGET)
  list(LENGTH ARGN COUNT)
  math(EXPR BATCHES "(${COUNT} + ${TOILE_BATCH} - 1) / ${TOILE_BATCH}")
  math(EXPR SIZE "(${COUNT} + ${BATCHES} - 1) / ${BATCHES}")
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD_BATCH_SIZE ${SIZE})
endfunction()

# toile_room(core/mesh USES pattern geometry): a static library named after the folder (proto/cpp becomes
# proto_cpp) from all its .cpp files, and those of the folders within it that PARTS names; other folders within
# it are rooms of their own. A room of headers only becomes an interface. A room of
# TOILE_LIGHT_ROOMS has no hot loop: it is compiled with -O1, which takes two thirds of the time.
function(toile_room FOLDER)
  cmake_parse_arguments(ROOM "" "" "USES;PARTS" ${ARGN})
  get_filename_component(NAME ${FOLDER} NAME)
  if(FOLDER STREQUAL "proto/cpp")
    set(NAME proto_cpp)
  endif()
  set(PLACES ${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp)
  foreach(PART ${ROOM_PARTS})
    list(APPEND PLACES ${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/${PART}/*.cpp)
  endforeach()
  file(GLOB SOURCES CONFIGURE_DEPENDS ${PLACES})
  if(SOURCES)
    add_library(${NAME} STATIC ${SOURCES})
    toile_batches(${NAME} ${SOURCES})
    target_include_directories(${NAME} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${NAME} PUBLIC ${ROOM_USES})
    if(FOLDER IN_LIST TOILE_NETWORK_ROOMS)
      target_compile_options(${NAME} PRIVATE ${TOILE_LIGHT})
      target_precompile_headers(${NAME} REUSE_FROM precompiled_network)
    elseif(FOLDER IN_LIST TOILE_LIGHT_ROOMS)
      target_compile_options(${NAME} PRIVATE ${TOILE_LIGHT})
      target_precompile_headers(${NAME} REUSE_FROM precompiled_light)
    else()
      target_precompile_headers(${NAME} REUSE_FROM precompiled_standard)
    endif()
  else()
    add_library(${NAME} INTERFACE)
    target_include_directories(${NAME} INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${NAME} INTERFACE ${ROOM_USES})
  endif()
endfunction()

# toile_test_program(test_garments garments analysis): a test program from all .cpp files of a folder of tests/.
function(toile_test_program NAME FOLDER)
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp)
  add_executable(${NAME} ${SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARGN} GTest::gtest_main)
  target_compile_options(${NAME} PRIVATE ${TOILE_LIGHT})
  target_precompile_headers(${NAME} REUSE_FROM precompiled_tests)
  target_compile_definitions(${NAME} PRIVATE TOILE_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                             TOILE_BINARY_DIR="${CMAKE_BINARY_DIR}")
endfunction()

# toile_tests(core/mesh mesh): such a program, each of its tests known to ctest. Suites whose name begins with
# "Long" get the label long: ./test leaves them out, ./test --long runs them. rapidcheck's properties are tried with
# the same cases in every run of ctest; a program run by hand takes others, and says with which seed. Tests of the
# service, the program and the rooms that share a drape out are labelled short-threads: those that ./test --long runs
# under ThreadSanitizer.
function(toile_tests FOLDER)
  file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp)
  if(NOT SOURCES)
    return()
  endif()
  string(REPLACE "/" "_" NAME test_${FOLDER})
  toile_test_program(${NAME} ${FOLDER} ${ARGN})
  set(SHORT short)
  if(FOLDER MATCHES "^(server/|app$|core/(base|collision|solver)$)")
    set(SHORT short-threads)
  endif()
  gtest_discover_tests(${NAME} TEST_FILTER -Long* DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 600 LABELS ${SHORT} ENVIRONMENT "RC_PARAMS=seed=1 max_success=500")
  gtest_discover_tests(${NAME} TEST_FILTER Long* TEST_LIST ${NAME}_long DISCOVERY_MODE PRE_TEST
                       DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 3600 LABELS long ENVIRONMENT "RC_PARAMS=seed=2 max_success=5000")
endfunction()
