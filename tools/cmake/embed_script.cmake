# Run by sunder_embed at build time: writes FILES as byte arrays (no compiler's limit on string literals applies).
set(arrays "")
set(entries "")
set(index 0)
list(SORT FILES)
foreach(file IN LISTS FILES)
  file(RELATIVE_PATH name ${BASE} ${file})
  file(READ ${file} hex HEX)
  string(LENGTH "${hex}" length)
  math(EXPR length "${length} / 2")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
  string(APPEND arrays "const char data${index}[] = {${bytes}'\\0'};\n")
  string(APPEND entries "    {\"${name}\", {data${index}, ${length}}},\n")
  math(EXPR index "${index} + 1")
endforeach()

file(WRITE ${OUTPUT}.hpp "#pragma once\n#include <span>\n\n#include \"core/embedded_file.hpp\"\n
namespace sunder::${NAMESPACE} {\nstd::span<const EmbeddedFile> embeddedFiles();\n}\n")
file(WRITE ${OUTPUT}.cpp "#include \"embedded_${NAMESPACE}.hpp\"\n\nnamespace {\n${arrays}\n
const sunder::EmbeddedFile files[] = {\n${entries}};\n}  // namespace\n
namespace sunder::${NAMESPACE} {\nstd::span<const EmbeddedFile> embeddedFiles() { return files; }\n}\n")
