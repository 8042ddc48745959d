# What CPack makes a package of Debian by, of what `cmake --install` installs: flowcert_VERSION-1~debN_ARCHITECTURE.deb.
#
#   SOURCE_DATE_EPOCH=SECONDS FLOWCERT_BUILD=BUILD_DIR cpack --config src/packages/deb.cmake -B OUT_DIR
#
# The build is of the Debian that this runs on, with the prefix /usr, and has the Python package. BUILD_DIR/bill/ has
# the bill of materials, flowcert.spdx.json, and notices/. debian/files.cmake puts in place what Debian has elsewhere,
# and adds what only a package has. The package is the same to the byte for the same build and time.
set(FLOWCERT_BUILD $ENV{FLOWCERT_BUILD})
set(FLOWCERT_DEBIAN ${CMAKE_CURRENT_LIST_DIR}/debian)
set(CPACK_GENERATOR DEB)
set(CPACK_CMAKE_GENERATOR Ninja)
set(CPACK_INSTALL_CMAKE_PROJECTS "${FLOWCERT_BUILD};flowcert;ALL;/")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${FLOWCERT_DEBIAN}/files.cmake)

file(STRINGS ${FLOWCERT_BUILD}/CMakeCache.txt version REGEX "^CMAKE_PROJECT_VERSION:")
string(REGEX REPLACE ".*=" "" CPACK_PACKAGE_VERSION "${version}")
set(CPACK_PACKAGE_NAME flowcert)
set(CPACK_PACKAGE_CONTACT "The Flowcert developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact flow complex of points in space")
set(CPACK_PACKAGE_DESCRIPTION "Flowcert computes all critical points of the distance to the nearest of given
points, and the flow between them, exactly, on every input: persistence
diagrams, pockets, rooms between atoms, surfaces of scans, medial axes.
It judges what others claim of them, and its own lists are proved by a checker
that shares no code with it.
.
This package has the programs, the library for C++ and the one for Python.")
# Unstable has no number.
file(STRINGS /etc/os-release release REGEX "^VERSION_ID=")
string(REGEX REPLACE ".*=\"?([0-9]+).*" "~deb\\1" release "${release}")
set(CPACK_DEBIAN_PACKAGE_RELEASE "1${release}")
set(CPACK_PACKAGE_FILE_NAME flowcert)  # of the folder that CPack works in
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The programs need neither Python nor a compiler.
file(GLOB core RELATIVE ${FLOWCERT_BUILD} ${FLOWCERT_BUILD}/python/flowcert/_core.cpython-*.so)
string(REGEX REPLACE ".*cpython-3([0-9]+).*" "\\1" minor "${core}")
math(EXPR next "${minor} + 1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "cmake, g++, libboost-dev, libexpat1-dev, libfmt-dev, libgmp-dev, libmpfr-dev, librapidcheck-dev, zlib1g-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${FLOWCERT_DEBIAN}/postinst ${FLOWCERT_DEBIAN}/prerm)
