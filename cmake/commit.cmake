# SPDX-License-Identifier: Apache-2.0
# quadrat_commit(SOURCE OUT): "1a875e5", "1a875e5-dirty" where files differ from it, "unknown" where nobody says.
# `git archive` writes the commit into this file (.gitattributes), so that a tarball knows its own.
set(QUADRAT_ARCHIVED_COMMIT "$Format:%h$")

function(quadrat_commit source out)
  set(commit "")
  if(EXISTS ${source}/.git)
    # A clone that is another user's is as good to read: sudo builds in one.
    execute_process(COMMAND git -c "safe.directory=*" -C ${source} describe --always --dirty --exclude=*
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      set(commit "")
    endif()
  elseif(NOT QUADRAT_ARCHIVED_COMMIT MATCHES "Format")
    set(commit ${QUADRAT_ARCHIVED_COMMIT})
  endif()
  if(NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
    set(commit unknown)
  endif()
  set(${out} ${commit} PARENT_SCOPE)
endfunction()
