# sunder_embed(TARGET NAMESPACE BASE FILES...)
#
# Compiles FILES (absolute paths) into TARGET. A generated header `embedded_<NAMESPACE>.hpp` declares
#     std::span<const sunder::core::EmbeddedFile> sunder::<NAMESPACE>::embeddedFiles();
# each with `name` (its path below BASE) and `text`. Sorted by name.
set(SUNDER_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_script.cmake)

function(sunder_embed target namespace base)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_${namespace})
  # The list goes through a file, rewritten only when it differs: no limit on a command line's length applies, and a file that
  # was added or taken away rebuilds under every generator.
  set(list ${output}.txt)
  list(SORT ARGN)
  string(REPLACE ";" "\n" lines "${ARGN}")
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}\n" @ONLY)
  add_custom_command(
    OUTPUT ${output}.cpp ${output}.hpp
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${namespace} -DBASE=${base} -DLIST=${list}
            -P ${SUNDER_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${list} ${SUNDER_EMBED_SCRIPT}
    COMMENT "Embedding ${namespace}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output}.cpp ${output}.hpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
