# SPDX-License-Identifier: Apache-2.0
# A Debian package by `cpack`: the program, its service and its rules. deploy/install makes the rest of the machine an
# exhibit: journal, boot, read-only root.
install(TARGETS quadrat DESTINATION bin)
install(TARGETS quadrat_images LIBRARY DESTINATION lib/quadrat)
install(DIRECTORY ${CMAKE_BINARY_DIR}/share/ DESTINATION share)  # manual pages and completion
file(STRINGS ${CMAKE_SOURCE_DIR}/deploy/system/files lines REGEX "^program ")
foreach(line IN LISTS lines)
  string(REPLACE " " ";" parts "${line}")
  list(GET parts 2 source)
  list(GET parts 3 destination)
  get_filename_component(folder ${destination} DIRECTORY)
  get_filename_component(name ${destination} NAME)
  string(REGEX REPLACE "^/usr/" "" folder ${folder})
  install(FILES ${CMAKE_SOURCE_DIR}/${source} DESTINATION ${folder} RENAME ${name})
endforeach()
install(FILES ${CMAKE_SOURCE_DIR}/deploy/quadrat.toml DESTINATION /etc/quadrat)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME quadrat)
set(CPACK_PACKAGE_CONTACT "the Quadrat project <quadrat@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "systemd, libegl-mesa0, libegl1, libgles2, libgl1-mesa-dri, fonts-lato, fonts-noto-core, fonts-droid-fallback, espeak-ng")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/deploy/system/conffiles
    ${CMAKE_SOURCE_DIR}/deploy/system/postinst ${CMAKE_SOURCE_DIR}/deploy/system/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
