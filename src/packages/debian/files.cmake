# CPack calls it before it packs: the files of the package go where Debian has them, and those come that only a package
# has. The bill's script knows what the programs have of others; see deb.cmake.
cmake_minimum_required(VERSION 3.25)
set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)
set(documents ${usr}/share/doc/flowcert)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB python ${usr}/lib/python3.*/dist-packages)
file(MAKE_DIRECTORY ${usr}/lib/python3)
file(RENAME ${python} ${usr}/lib/python3/dist-packages)
cmake_path(GET python PARENT_PATH python)
file(REMOVE_RECURSE ${python})
# By these metadata pip knows that the package is there.
run(${CMAKE_COMMAND} -E env PYTHONPATH=${FLOWCERT_DEBIAN}/../../python/build_backend PYTHONDONTWRITEBYTECODE=1
  python3 -c "import flowcert_build
flowcert_build.prepare_metadata_for_build_wheel('${usr}/lib/python3/dist-packages')")
file(REMOVE ${usr}/lib/python3/dist-packages/flowcert-${CPACK_PACKAGE_VERSION}.dist-info/LICENSE)
file(RENAME ${usr}/share/zsh/site-functions ${usr}/share/zsh/vendor-completions)

# CPack strips what is installed as a program. The linker needs no more of an archive than this.
file(GLOB core ${usr}/lib/python3/dist-packages/flowcert/_core*.so)
run(strip --remove-section=.comment --strip-unneeded ${core})
file(GLOB_RECURSE archives ${usr}/lib/*.a)
run(strip --enable-deterministic-archives --strip-debug --remove-section=.comment ${archives})

file(COPY ${FLOWCERT_DEBIAN}/copyright ${FLOWCERT_BUILD}/bill/flowcert.spdx.json ${FLOWCERT_BUILD}/bill/notices
     DESTINATION ${documents})
set(deb_version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH
file(WRITE ${documents}/changelog.Debian
"flowcert (${deb_version}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}; spec/CHANGELOG.md of the source says what changed.

 -- ${CPACK_PACKAGE_CONTACT} <>  ${date}
")
file(GLOB pages ${usr}/share/man/man1/*)
run(gzip -9n ${documents}/changelog.Debian ${pages})
file(COPY ${FLOWCERT_DEBIAN}/lintian-overrides DESTINATION ${usr}/share/lintian/overrides)
file(RENAME ${usr}/share/lintian/overrides/lintian-overrides ${usr}/share/lintian/overrides/flowcert)
# CPack leaves the times of files as they are.
run(find ${usr} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +)
