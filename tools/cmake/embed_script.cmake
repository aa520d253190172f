# Run by sunder_embed at build time: writes the files named in LIST as byte arrays (no compiler's limit on string literals
# applies).
file(STRINGS ${LIST} files)
set(arrays "")
set(entries "")
set(index 0)
foreach(file IN LISTS files)
  file(RELATIVE_PATH name ${BASE} ${file})
  file(SIZE ${file} size)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
  string(APPEND arrays "const char data${index}[] = {${bytes}'\\0'};\n")
  string(APPEND entries "    {\"${name}\", {data${index}, ${size}}},\n")
  math(EXPR index "${index} + 1")
endforeach()

file(WRITE ${OUTPUT}.hpp "#pragma once\n#include <span>\n\n#include \"core/embedded_file.hpp\"\n
namespace sunder::${NAMESPACE} {\nstd::span<const core::EmbeddedFile> embeddedFiles();\n}\n")
file(WRITE ${OUTPUT}.cpp "#include \"embedded_${NAMESPACE}.hpp\"\n\n#include <array>\n\nnamespace {\n${arrays}
const std::array<sunder::core::EmbeddedFile, ${index}> embedded = {{\n${entries}}};\n}  // namespace\n
namespace sunder::${NAMESPACE} {\nstd::span<const core::EmbeddedFile> embeddedFiles() { return embedded; }\n}\n")
