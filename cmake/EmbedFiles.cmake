# cmake -DROOT=DIR -DFILES="a;b" -DHEADER=H -DNAMESPACE=N -DTYPE=T -DFUNCTION=F -DOUT=X.cpp -P EmbedFiles.cmake
# Writes the definition of `std::span<const T> F()`, which H declares in namespace N: a row {path, text} a file. Called
# through warpgrain_embed (WarpgrainTargets.cmake).
set(text "// Generated from the files of ${ROOT}; do not edit.\n#include \"${HEADER}\"\n\n")
string(APPEND text "namespace ${NAMESPACE} {\nnamespace {\n")
set(rows "")
set(n 0)
foreach(name IN LISTS FILES)
  file(READ "${ROOT}/${name}" content)
  # A literal of more than 64 KiB is not portable; neither would a file of that size be readable.
  string(APPEND text "const char file_${n}[] = R\"warpgrain_text(${content})warpgrain_text\";\n")
  string(APPEND rows "    {\"${name}\", file_${n}},\n")
  math(EXPR n "${n} + 1")
endforeach()
string(APPEND text "const ${TYPE} table[] = {\n${rows}};\n}  // namespace\n\n")
string(APPEND text "std::span<const ${TYPE}> ${FUNCTION}() { return table; }\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUT}" "${text}")
