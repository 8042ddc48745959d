# A toolchain for CMake: Debian's emscripten, and the libraries that libraries.sh makes in FLOWCERT_WEB_LIBRARIES.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FLOWCERT_WEB_LIBRARIES)
list(PREPEND CMAKE_FIND_ROOT_PATH ${FLOWCERT_WEB_LIBRARIES})
list(APPEND CMAKE_SYSTEM_PREFIX_PATH /usr /usr/lib/x86_64-linux-gnu/cmake)
# Only C++'s own exceptions, in WebAssembly's instructions; those of emscripten go through JavaScript.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -msimd128")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${FLOWCERT_WEB_LIBRARIES}/usr/lib")
