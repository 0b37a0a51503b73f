# Debian's packages, by `cpack`: the headers, and the program where it is built. Each has the dependencies that it
# needs, so that who only meshes files installs no compiler's headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bubble-relaxation-2)
set(CPACK_PACKAGE_CONTACT "The Bubble_relaxation_2 authors")
set(CPACK_PACKAGE_VENDOR "${CPACK_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL headers)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libcgal-bubble-relaxation-2-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "libtbb-dev, libeigen3-dev, libopenmpi-dev")
set(CPACK_COMPONENT_HEADERS_DESCRIPTION
    "Headers for programs that mesh domains, and find_package(Bubble_relaxation_2) for CMake.")
if(NOT TARGET Bubble_relaxation_2_core) # the compiled core is for one architecture
  set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
endif()

if(TARGET npbs_mesh)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME npbs-mesh)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
      "npbs_mesh reads outlines and writes meshes for ParaView, Gmsh, SMS, ADCIRC, SCHISM and Triangle.")
endif()

# what Debian wants to find beside each package; other ways to install have the licence under its own name
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_HEADERS_PACKAGE_NAME} RENAME copyright
        COMPONENT headers EXCLUDE_FROM_ALL)
if(TARGET npbs_mesh)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_PROGRAM_PACKAGE_NAME}
          RENAME copyright COMPONENT program EXCLUDE_FROM_ALL)
endif()

# headers can be installed without a build, the program's package cannot be made without the program
if(TARGET npbs_mesh)
  set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/Bubble_relaxation_2_cpack.cmake)
  file(GENERATE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} CONTENT "if(NOT EXISTS \"$<TARGET_FILE:npbs_mesh>\")
  message(FATAL_ERROR \"there is no npbs_mesh to pack: build the target npbs_mesh first\")
endif()
")
endif()
include(CPack)
