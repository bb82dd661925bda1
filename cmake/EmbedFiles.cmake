# cmake -DROOT=DIR -DFILES="a;b" -DOUT=X.cpp -P EmbedFiles.cmake
# Writes the table behind kernels/kernel_sources.hpp. Raw string literals, cut where compilers limit their length.
set(text "// Generated from kernels/; do not edit.\n#include \"kernels/embedded_kernels.hpp\"\n\n")
string(APPEND text "namespace warpgrain {\nnamespace {\n")
set(rows "")
set(n 0)
foreach(name IN LISTS FILES)
  file(READ "${ROOT}/${name}" content)
  # A literal of more than 64 KiB is not portable; neither would a kernel file of that size be readable.
  string(APPEND text "const char file_${n}[] = R\"warpgrain_cl(${content})warpgrain_cl\";\n")
  string(APPEND rows "    {\"${name}\", file_${n}},\n")
  math(EXPR n "${n} + 1")
endforeach()
string(APPEND text "const EmbeddedKernel table[] = {\n${rows}};\n}  // namespace\n\n")
string(APPEND text "std::span<const EmbeddedKernel> embedded_kernels() { return table; }\n\n}  // namespace warpgrain\n")
file(WRITE "${OUT}" "${text}")
