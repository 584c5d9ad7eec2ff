# Planted faults (fuzz/mutants/README.md). With OCCLUDE_MUTANT=NAME the kernel, the culler and the readers of models
# are built from a copy in the build folder to which fuzz/mutants/NAME.patch was applied, to check that the tests and the fuzzer
# catch the fault. Included once, from the top. Sets OCCLUDE_SOURCES, the folder from which kernel/, culler/ and render/models/
# are built.
set(OCCLUDE_MUTANT "" CACHE STRING "Planted fault to build with, for testing the tests: a name from fuzz/mutants, or none")
set(OCCLUDE_SOURCES ${PROJECT_SOURCE_DIR})

# occlude_plant(NAME FOLDER): makes FOLDER/kernel, FOLDER/culler and FOLDER/render/models, copies with the fault. Unchanged files keep their time.
function(occlude_plant name folder)
  set(patch ${PROJECT_SOURCE_DIR}/fuzz/mutants/${name}.patch)
  if(NOT EXISTS ${patch})
    file(GLOB names RELATIVE ${PROJECT_SOURCE_DIR}/fuzz/mutants ${PROJECT_SOURCE_DIR}/fuzz/mutants/*.patch)
    list(TRANSFORM names REPLACE "\\.patch$" "")
    list(JOIN names " " names)
    message(FATAL_ERROR "OCCLUDE_MUTANT: there is no fault ${name}. There are: ${names}")
  endif()
  find_program(OCCLUDE_PATCH patch REQUIRED)

  set(fresh ${folder}.new)
  file(REMOVE_RECURSE ${fresh})
  file(COPY ${PROJECT_SOURCE_DIR}/kernel ${PROJECT_SOURCE_DIR}/culler DESTINATION ${fresh})
  file(COPY ${PROJECT_SOURCE_DIR}/render/models DESTINATION ${fresh}/render)
  execute_process(COMMAND ${OCCLUDE_PATCH} --strip=1 --fuzz=0 --no-backup-if-mismatch --silent
    --input=${patch} WORKING_DIRECTORY ${fresh}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(status)
    message(FATAL_ERROR "OCCLUDE_MUTANT: ${name}.patch does not apply\n${said}")
  endif()

  file(GLOB_RECURSE old RELATIVE ${folder} ${folder}/*)
  file(GLOB_RECURSE new RELATIVE ${fresh} ${fresh}/*)
  foreach(path IN LISTS new)
    cmake_path(GET path PARENT_PATH parent)
    file(MAKE_DIRECTORY ${folder}/${parent})
    file(COPY_FILE ${fresh}/${path} ${folder}/${path} ONLY_IF_DIFFERENT)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path})
  endforeach()
  list(REMOVE_ITEM old ${new})
  foreach(path IN LISTS old)
    file(REMOVE ${folder}/${path})
  endforeach()
  file(REMOVE_RECURSE ${fresh})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${patch})
endfunction()

if(OCCLUDE_MUTANT)
  set(OCCLUDE_SOURCES ${PROJECT_BINARY_DIR}/mutant)
  occlude_plant(${OCCLUDE_MUTANT} ${OCCLUDE_SOURCES})
  message(STATUS "Planted fault: ${OCCLUDE_MUTANT}")
endif()
