# SPDX-License-Identifier: Apache-2.0
# quadrat_embed(TARGET NAMESPACE HEADER FUNCTION FILE...): the texts of FILEs in the binary, as
#     std::span<const base::EmbeddedText> NAMESPACE::FUNCTION()
# declared in HEADER, in the order given, each named by its file's stem.
set(QUADRAT_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_texts.cmake)

function(quadrat_embed target namespace header function)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${generated} -DNAMESPACE=${namespace} -DHEADER=${header} -DFUNCTION=${function}
            "-DFILES=${ARGN}" -P ${QUADRAT_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${QUADRAT_EMBED_SCRIPT}
    COMMENT "Embedding ${function}" VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
