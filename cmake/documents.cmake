# Installs the documents and the examples: README.md, docs/, images/ and examples/ in the folder for documentation. Included by
# install.cmake.
set(document_folder ${PROJECT_BINARY_DIR}/package/documents)

# occlude_install_document(FILE UP): the document with links to what is installed. Those to other files of the project become their
# text. UP leads from its folder to that of README.md.
function(occlude_install_document file up)
  cmake_path(GET file PARENT_PATH folder)
  set(folder_in_documents /prefix/${CMAKE_INSTALL_DOCDIR}/${folder})
  set(to_headers /prefix/${CMAKE_INSTALL_INCLUDEDIR})
  cmake_path(RELATIVE_PATH to_headers BASE_DIRECTORY ${folder_in_documents})
  file(READ ${PROJECT_SOURCE_DIR}/${file} text)
  string(REGEX REPLACE "\\]\\(${up}culler/example/([a-z]+\\.[a-z]+)" "](${up}examples/\\1" text "${text}")
  string(REPLACE "](${up}render/images/" "](${up}images/" text "${text}")
  string(REGEX REPLACE "\\]\\(${up}(kernel|culler/[a-z]+)/include/" "](${to_headers}/" text "${text}")
  string(REGEX REPLACE "\\[([^]]*)\\]\\(${up}((kernel|culler|oracle|render|fuzz|tests)/|CONTRIBUTING)[^)]*\\)" "\\1" text "${text}")
  file(WRITE ${document_folder}/${file} "${text}")
  install(FILES ${document_folder}/${file} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
endfunction()

occlude_install_document(README.md "")
occlude_install_document(CHANGELOG.md "")
file(GLOB guides CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/docs/*.md)
foreach(guide IN LISTS guides)
  occlude_install_document(${guide} "../")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/culler/example/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples PATTERN osg EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/render/images DESTINATION ${CMAKE_INSTALL_DOCDIR})
