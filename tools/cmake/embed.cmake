# sunder_embed(TARGET NAMESPACE BASE FILES...)
#
# Compiles FILES into TARGET. A generated header `embedded_<NAMESPACE>.hpp` declares
#     std::span<const sunder::EmbeddedFile> sunder::<NAMESPACE>::embeddedFiles();
# each with `name` (its path below BASE) and `text`. Sorted by name.
set(SUNDER_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_script.cmake)

function(sunder_embed target namespace base)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_${namespace})
  add_custom_command(
    OUTPUT ${output}.cpp ${output}.hpp
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}" "-DBASE=${base}"
            "-DFILES=${ARGN}" -P ${SUNDER_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${SUNDER_EMBED_SCRIPT}
    COMMENT "Embedding ${namespace}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output}.cpp ${output}.hpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
