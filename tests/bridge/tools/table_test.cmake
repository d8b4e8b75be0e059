# The table in the documentation is the one that the program writes.
file(COPY_FILE "${page}" "${copy}")
execute_process(COMMAND "${program}" --table "${copy}" COMMAND_ERROR_IS_FATAL ANY)
file(READ "${page}" documented)
file(READ "${copy}" written)
if(NOT documented STREQUAL written)
    message(FATAL_ERROR "run: ${program} --table ${page}")
endif()
