# cmake -DFILE=F -DHEADER=H -DNAMESPACE=N -DFUNCTION=F -DOUT=X.cpp -P EmbedBytes.cmake
# Writes the definition of `std::string_view F()`, which H declares in namespace N: the bytes of FILE.
file(READ "${FILE}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\"\n    \"" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
set(text "// Generated from ${FILE}; do not edit.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\nnamespace {\n")
string(APPEND text "const char bytes[] =\n    \"${bytes}\";\n}  // namespace\n\n")
string(APPEND text "std::string_view ${FUNCTION}() { return {bytes, sizeof bytes - 1}; }\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUT}" "${text}")
