# Fails if a kernels_*.cpp object in LIBRARY defines a symbol that the linker may merge with one of
# another file: weak (W, V) or unique (u).
execute_process(COMMAND ${NM} -A -C ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed)
    message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]*:kernels_[^\n]* T [^\n]*kernel_[^\n]*" found "${symbols}")
if(NOT found)
    message(FATAL_ERROR "no kernels in ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]*:kernels_[^\n]* [WVu] [^\n]*" shared "${symbols}")
# Highway's names carry the instruction set, so no other file has them; a reference to the handler
# of exceptions, which unoptimised builds emit, is not code.
list(FILTER shared EXCLUDE REGEX " hwy::N_|[^\n]* V DW\\.ref\\.")
if(shared)
    list(JOIN shared "\n" text)
    message(FATAL_ERROR "symbols that other files may share:\n${text}")
endif()
